package dev.lazyz.cli.batch

import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputClosed
import dev.lazyz.cli.output.Progress
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.output.printable
import dev.lazyz.cli.render.StatsForm
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.outputs.ContactSheet
import dev.lazyz.scenes.pictures.PictureParameters
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.Future
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/**
 * One run of `zcli render` with several pictures: several inputs at the same time, on all threads together. Reports
 * come in the order of the inputs. An input that fails does not stop the others.
 */
internal class BatchJob(private val request: BatchRequest, private val streams: Streams) {
    private val plan = BatchPlan(request)
    private var failed = 0
    private var isBuggy = false

    /** Whether nobody reads standard output any more. The files are still written. */
    private var isClosed = false

    /** Returns the exit code. */
    fun run(): Int {
        // Report mistakes in the options before anything is read
        val threads = request.choices.options().threads
        StrategyChoice(request.strategy, request.choices.sharing(threads))
        request.inputs.firstOrNull()?.let { request.shown(it) }
        val sheet = if (plan.kind == Kind.SHEET) sheet() else null
        val total = Runtime.getRuntime().maxMemory().let { it - it / FREE_PART }
        val left = total - if (sheet == null) 0 else bytes(sheet)
        if (left < total / 2) throw Mistake(tooLarge(checkNotNull(sheet), total))

        // Render
        val pictures = plan.inputs.size * plan.perInput
        streams.progress("rendering ${counted(pictures.toLong(), "picture")} ...")
        val progress = Progress(streams, pictures, "pictures")
        val shares = Shares(MemoryShare(left), ThreadShare(threads), progress, sheet)
        val pool = Executors.newFixedThreadPool(minOf(threads, plan.inputs.size))
        try {
            val jobs = plan.inputs.map {
                pool.submit<InputReport> { InputJob(request, plan, it, shares, streams).run() }
            }
            for ((job, input) in jobs.zip(plan.inputs)) report(input, result(job, input.input), sheet)
        } finally {
            pool.shutdownNow()
        }

        // Write the sheet, also if some of its pictures are missing
        if (sheet != null && !sheet.isEmpty) {
            sheet.write(plan.sheet)
            streams.remark("wrote ${plan.sheet}, ${sheet.width}x${sheet.height}")
        }
        if (failed > 0 && plan.inputs.size > 1) streams.error("$failed of ${plan.inputs.size} inputs failed")
        return when {
            isBuggy -> ExitCode.BUG
            failed > 0 -> ExitCode.MISTAKE
            else -> request.blanks.code(ExitCode.DONE)
        }
    }

    private fun result(job: Future<InputReport>, input: String): InputReport = try {
        job.get()
    } catch (e: ExecutionException) {
        InputReport(input, "", "", emptyList(), e.cause ?: e)
    }

    private fun report(input: InputPlan, report: InputReport, sheet: ContactSheet?) = synchronized(streams) {
        if (report.messages.isNotEmpty()) streams.note(report.messages)
        print(report.output)
        for (file in report.files) streams.remark("wrote $file")
        val message = report.failure?.let { report(report.input, it) } ?: return
        val cells = input.views.flatMap { view -> view.labels.indices.map { view.firstCell + it } }
        cells.forEach { sheet?.fail(it, message) }
    }

    private fun print(text: String) {
        if (isClosed) return
        try {
            streams.print(text)
            streams.output.flush()
        } catch (_: OutputClosed) {
            isClosed = true
        }
    }

    /** Reports the failure, and returns the reason without the name of the input. */
    private fun report(input: String, failure: Throwable): String {
        failed++
        val mistake = Failure.mistake(failure)
        if (mistake == null) {
            isBuggy = true
            streams.note(Failure.bugReport(failure, request.args.toTypedArray()) + "\n")
        }
        val message = mistake ?: "bug in zcli, $failure"
        val name = printable(input)
        streams.error(if (name in message) message else "$name: $message")
        val reason = message.removePrefix(name).trimStart(',', ':', ' ')
        if (request.stats != StatsForm.JSON) return reason
        val line = buildJsonObject {
            put("input", input)
            put("message", message)
        }
        print(Json.of(line) + "\n")
        return reason
    }

    private fun sheet(): ContactSheet {
        val settings = request.shown(request.inputs[0]).settings
        val size = settings[PictureParameters.REGION]?.let { ImageSize(it.width, it.height) } ?: settings.size
        if (size.width.toLong() * size.height > MOST_PIXELS) {
            throw Mistake(
                "a picture of a contact sheet has at most $MOST_PIXELS pixels, not ${size.width}x${size.height}; " +
                    "choose a smaller --size",
            )
        }
        val labels = plan.inputs.flatMap { input -> input.views.flatMap { it.labels } }
        return ContactSheet.of(settings, labels, request.series.columns, plan.perInput)
    }

    private fun bytes(sheet: ContactSheet): Long = BYTES_PER_PIXEL * sheet.width * sheet.height

    private fun tooLarge(sheet: ContactSheet, total: Long): String =
        "a contact sheet of ${sheet.width}x${sheet.height} needs ${Bytes.readable(bytes(sheet))} of memory, of the " +
            "${Bytes.readable(total)} that there are for all; choose a smaller --size, or fewer pictures"

    private companion object {
        /** This part of Java's memory is for what is not counted. */
        const val FREE_PART = 8
        const val BYTES_PER_PIXEL = 4L

        /** They are in an array. */
        const val MOST_PIXELS = Int.MAX_VALUE - 8L
    }
}
