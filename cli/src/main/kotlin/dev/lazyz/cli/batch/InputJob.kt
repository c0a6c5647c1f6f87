package dev.lazyz.cli.batch

import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.SceneFormatException
import java.io.ByteArrayOutputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Path

/**
 * Renders all pictures of one input. Reads it once, and holds memory meanwhile: first as much as most files need; if
 * that is too little, it begins again with what the limits permit, and at last with all memory.
 *
 * @param streams where standard input comes from
 */
internal class InputJob(
    private val request: BatchRequest,
    private val plan: BatchPlan,
    private val input: InputPlan,
    private val shares: Shares,
    private val streams: Streams,
) {
    private val subject: Subject = request.subject(input.input)
    private var counted = 0

    /** Renders the pictures, and reports what happened. Failures are reported, not thrown. */
    fun run(): InputReport {
        try {
            val usual = StrategyChoice(request.strategy, request.choices.sharing(1)).usual
            val memory = InputMemory(subject, usual, plan, shares.memory.total)
            for (step in memory.steps()) {
                val report = shares.memory.hold(step.bytes) {
                    shares.threads.forInput { attempt(memory, step) }
                }
                if (report != null) return report
            }
            error("the last attempt at ${input.input} has no report")
        } finally {
            while (counted < plan.perInput) count(counted)
        }
    }

    /** Returns the report, or null if it must be tried again with more memory. */
    private fun attempt(memory: InputMemory, step: MemoryStep): InputReport? {
        val messages = ByteArrayOutputStream()
        val own = Streams(streams.input, OutputStream.nullOutputStream(), PrintStream(messages))
        val statistics = StringBuilder()
        val files = ArrayList<Path>()
        var failure: Throwable? = null
        try {
            val source = FrameSource(subject, own, step.loading)
            TimeLimit.OF_INPUT.hold(subject.timeLimit, source.input.name) {
                val loaded = source.load()
                source.requireKept(loaded, plan.replaced)
                val pictures = InputPictures(request, plan, shares, source, loaded, own, ::count) { strategy, shot ->
                    memory.require(step, strategy, shot)
                }
                input.views.forEach { pictures.render(it, statistics, files) }
            }
        } catch (e: InterruptedException) {
            throw e
        } catch (e: Throwable) {
            if (!step.isLast && needsMore(e, step)) return null
            failure = e
        }
        own.flushMessages()
        return InputReport(input.input, messages.toString(), statistics.toString(), files, failure)
    }

    /** Counts the picture with this number of the input as done, once. */
    private fun count(number: Int) {
        if (number < counted) return
        counted = number + 1
        shares.progress.advance()
    }

    /** A file that cannot be read within reduced limits is read again, because the limits may be the reason. */
    private fun needsMore(failure: Throwable, step: MemoryStep): Boolean =
        failure is TooLittleMemory || (failure is SceneFormatException && step.isReduced) ||
            generateSequence(failure) { it.cause }.any { it is OutOfMemoryError }
}

/**
 * What there is to say about an input after it was rendered.
 *
 * @property messages warnings and other text for standard error
 * @property output statistics for standard output
 * @property files the files that were written
 * @property failure why a picture is missing, or null
 */
internal class InputReport(
    val input: String,
    val messages: String,
    val output: String,
    val files: List<Path>,
    val failure: Throwable?,
)
