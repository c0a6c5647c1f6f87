package dev.lazyz.cli.render

import dev.lazyz.cli.diff.DifferenceText
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Statistics
import dev.lazyz.cli.output.StatisticsTable
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Tally
import dev.lazyz.cli.strategies.MemoryNeed
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.LoadedScene
import kotlinx.serialization.json.JsonObject

/** One run of `zcli render`: reads, sets up, chooses a strategy, renders to all sinks at once, compares, reports. */
internal class RenderJob(private val request: RenderRequest, private val streams: Streams) {
    /** Returns the exit code. */
    fun run(): Int {
        // Report mistakes in the options before anything is read
        val source = FrameSource(request.subject, streams)
        val choice = StrategyChoice(request.strategy, request.choices)
        val outputs = Outputs(request, source.input, streams)
        val reference = request.reference?.let { ReferenceCheck(it) }

        request.streaming?.requirePossible(request)
        val streaming = request.streaming ?: return run(source, source.load(), choice, outputs, reference)
        return source.stream(streaming.spool).use { run(source, it.loaded, choice, outputs, reference) }
    }

    private fun run(
        source: FrameSource,
        loaded: LoadedScene,
        choice: StrategyChoice,
        outputs: Outputs,
        reference: ReferenceCheck?,
    ): Int {
        // Set up, and choose a strategy that supports the frame
        source.requireKept(loaded, outputs.replaced)
        val start = System.nanoTime()
        val shot = source.frame(loaded, request.choices.options())
        val frame = shot.frame
        val strategy = choice.strategyFor(frame)
        if (request.isExplained) streams.note(choice.explain(strategy, frame))
        val kept = (reference?.bytesPerPixel ?: 0) + request.aovs.bytesPerPixel / (shot.factor * shot.factor)
        MemoryNeed.check(strategy, frame.region, kept, aa = shot.factor)

        // Render to all outputs at once
        streams.progress("rendering ${frame.primitives.size} primitives with ${strategy.id} ...")
        val tally = Tally(shot.pixels.width, request.stats != null)
        val colors = reference?.let { ColorRows(shot.pixels) }
        val sinks = listOfNotNull(tally, colors, ProgressSink.of(streams, shot.pixels.height))
        val aovs = request.aovs.aovs
        val counters = outputs.write(shot, sinks) { sink ->
            if (aovs.isEmpty()) {
                shot.render(strategy, sink)
            } else {
                shot.render(strategy, sink, aovs).also { request.aovs.write(it) }.counters
            }
        }
        val nanoseconds = System.nanoTime() - start

        // Report
        if (tally.visible == 0L) streams.nothingIsVisible()
        outputs.describe(shot.pixels)
        val name = source.input.name
        val difference = colors?.let { reference.compare(it) }
        val comparison = difference?.let { DifferenceText("${request.reference?.file}", name, it) }
        if (difference?.isMatch == false) streams.note(comparison?.lines.orEmpty())
        if (request.stats != null) {
            val warnings = loaded.warnings.size
            val statistics =
                Statistics(name, strategy, shot.pixels, shot.factor, counters, tally, warnings, nanoseconds)
            printStatistics(request.stats, statistics, comparison?.toJson())
        }
        return if (difference?.isMatch == false) ExitCode.DIFFERENT else ExitCode.DONE
    }

    /** Prints [statistics] to standard output, or to standard error if standard output contains the picture. */
    private fun printStatistics(form: StatsForm, statistics: Statistics, comparison: JsonObject?) {
        val text = if (form == StatsForm.JSON) statistics.toJson(comparison) + "\n" else StatisticsTable.of(statistics)
        if (request.output == Outputs.STANDARD_OUTPUT) streams.messages.print(text) else streams.print(text)
    }
}
