package dev.lazyz.cli.compare

import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.OutputClosed
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.output.printable
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/** The outcome for one input, from best to worst. */
internal enum class Verdict(val word: String) {
    /** All strategies that can render it gave the same pictures. */
    OK("ok"),

    /** It could not be read or compared. */
    ERROR("error"),

    /** A strategy threw an exception, or did not deliver all rows. */
    FAILED("failed"),

    /** A picture differs from that of the first strategy. */
    DIFFERS("differs"),
}

/**
 * One run of `zcli compare` over several inputs or views. Prints a line for each input as soon as it is done, then a
 * summary; or JSON lines. Only one input is in memory at a time. An input that fails does not stop the run.
 *
 * @param shown returns what to show of the input with the given name
 * @param args the words of the command line, for bug reports
 */
internal class CompareSeveralJob(
    private val request: CompareRequest,
    private val streams: Streams,
    private val shown: (String) -> ShownInput,
    private val args: List<String>,
) {
    private val job = CompareJob(request, streams)
    private val verdicts = mutableListOf<Verdict>()
    private var pictures = 0
    private var blank = 0
    private var isBuggy = false

    /** Compares pictures of all [inputs], prints the results, as JSON if [isJson], and returns the exit code. */
    fun run(inputs: Sequence<String>, isJson: Boolean): Int {
        for (input in inputs) {
            val line = compare(input, isJson)
            verdicts += line.verdict
            if (!isJson) printLine(line.toString())
        }
        printLine(if (isJson) Json.of(totals()) else summary())
        return when {
            Verdict.DIFFERS in verdicts || Verdict.FAILED in verdicts -> ExitCode.DIFFERENT
            isBuggy -> ExitCode.BUG
            Verdict.ERROR in verdicts -> ExitCode.MISTAKE
            else -> ExitCode.DONE
        }
    }

    private fun compare(input: String, isJson: Boolean): CompareLine {
        val line = CompareLine(input)
        try {
            val shown = shown(input)
            TimeLimit.OF_INPUT.hold(shown.timeLimit, input) { compare(shown, line, isJson) }
        } catch (closed: OutputClosed) {
            throw closed
        } catch (failure: Throwable) {
            // Continue with the other inputs
            val mistake = Failure.mistake(failure)
            if (mistake == null) report(failure)
            val message = mistake ?: "bug in zcli, $failure"
            line.add(message)
            streams.error(line.named(message))
            if (isJson) printLine(Json.of(error(input, message)))
        }
        return line
    }

    private fun compare(shown: ShownInput, line: CompareLine, isJson: Boolean) {
        val source = FrameSource(shown, streams)
        val loaded = source.read()
        for (view in request.views.ifEmpty { listOf(null) }) {
            val comparison = job.compare(source, loaded, view)
            pictures++
            if (comparison.blank != null) blank++
            if (request.blanks.isMistake) request.blanks.report(comparison.blank, streams, comparison.name)
            line.add(comparison)
            comparison.bugs.forEach { report(it) }
            if (isJson) printLine(comparison.toJson())
        }
    }

    private fun report(bug: Throwable) {
        isBuggy = true
        streams.note(Failure.bugReport(bug, args.toTypedArray()) + "\n")
    }

    /** Prints a line and flushes, so that it appears at once. */
    private fun printLine(line: String) {
        streams.print(line + "\n")
        streams.output.flush()
    }

    private fun count(verdict: Verdict): Int = verdicts.count { it == verdict }

    private fun summary(): String {
        fun counted(verdict: Verdict, one: String, several: String) = counted(count(verdict).toLong(), one, several)
        val outcomes = listOf(
            counted(Verdict.OK, "ok", "ok"),
            counted(Verdict.DIFFERS, "differs", "differ"),
            counted(Verdict.FAILED, "failed", "failed"),
            counted(Verdict.ERROR, "error", "errors"),
        )
        return "${counted(verdicts.size.toLong(), "input")}: ${outcomes.joinToString()}; " +
            "${counted(pictures.toLong(), "picture")}, %,d of them blank".format(null, blank)
    }

    private fun totals(): JsonObject = buildJsonObject {
        put("inputs", verdicts.size)
        for (verdict in Verdict.entries) put(verdict.word, count(verdict))
        put("pictures", pictures)
        put("blank", blank)
    }

    private fun error(input: String, message: String): JsonObject = buildJsonObject {
        put("input", input)
        put("message", message)
    }
}

/** The line that is printed for one input. */
private class CompareLine(input: String) {
    private val name = printable(input)
    var verdict = Verdict.OK
        private set

    private var message = ""
    private var primitives = 0
    private var notBlending = 0
    private var blank = 0

    fun add(comparison: Comparison) {
        primitives = maxOf(primitives, comparison.shot.frame.primitives.size)
        notBlending = comparison.outcomes.count { (_, outcome) -> outcome is Outcome.NotBlending }
        if (comparison.blank != null) blank++
        val view = comparison.view?.let { "${it.name.lowercase()}: " }.orEmpty()
        for ((id, outcome) in comparison.outcomes) {
            when (outcome) {
                is Outcome.Failed -> worsen(Verdict.FAILED, "$view$id failed: ${outcome.message}")
                is Outcome.Rendered -> outcome.difference?.let {
                    worsen(Verdict.DIFFERS, view + comparison.sentence(id, it))
                }
                is Outcome.NotBlending -> Unit
            }
        }
    }

    /** Returns [message] with the name of the input. Messages about files already begin with it. */
    fun named(message: String): String = if (message.startsWith(name)) message else "$name: $message"

    /** Adds why the input could not be compared. */
    fun add(mistake: String) = worsen(Verdict.ERROR, mistake)

    /** Keeps the first message of the worst verdict. */
    private fun worsen(other: Verdict, why: String) {
        if (other <= verdict) return
        verdict = other
        message = why.lineSequence().first()
    }

    override fun toString(): String {
        val lead = verdict.word.padEnd(Verdict.entries.maxOf { it.word.length } + 2)
        if (verdict != Verdict.OK) return lead + named(message)
        return buildString {
            append("$lead$name: ").append(counted(primitives.toLong(), "primitive"))
            if (notBlending > 0) {
                append(", translucent: ${counted(notBlending.toLong(), "strategy", "strategies")} left out")
            }
            if (blank > 0) append(", nothing to see")
        }
    }
}
