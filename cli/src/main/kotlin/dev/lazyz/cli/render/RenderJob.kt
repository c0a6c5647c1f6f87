package dev.lazyz.cli.render

import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.output.Statistics
import dev.lazyz.cli.output.StatisticsTable
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Tally
import dev.lazyz.cli.strategies.MemoryNeed
import dev.lazyz.cli.strategies.StrategyChoice

/** One run of `zcli render`: reads, sets up, chooses a strategy, renders to all sinks at once, prints statistics. */
internal class RenderJob(private val request: RenderRequest, private val streams: Streams) {
    fun run() {
        // Report mistakes in the options before anything is read
        val source = FrameSource(request.subject, streams)
        val choice = StrategyChoice(request.strategy, request.choices)
        val outputs = Outputs(request, source.input, streams)

        // Read, set up, and choose a strategy that supports the frame
        val loaded = source.load()
        val start = System.nanoTime()
        val shot = source.frame(loaded, request.choices.options())
        val frame = shot.frame
        val strategy = choice.strategyFor(frame)
        if (request.isExplained) streams.note(choice.explain(strategy, frame))
        MemoryNeed.check(strategy, frame.region, aa = shot.factor)

        // Render to all outputs at once
        streams.progress("rendering ${frame.primitives.size} primitives with ${strategy.id} ...")
        val tally = Tally(shot.pixels.width, request.stats != null)
        val counters = outputs.write(shot, tally) { sink -> shot.render(strategy, sink) }
        val nanoseconds = System.nanoTime() - start

        // Report
        if (tally.visible == 0L) streams.nothingIsVisible()
        outputs.describe(shot.pixels)
        val form = request.stats ?: return
        val name = source.input.name
        val warnings = loaded.warnings.size
        val statistics =
            Statistics(name, strategy, shot.pixels, shot.factor, counters, tally, warnings, nanoseconds)
        printStatistics(form, statistics)
    }

    /** Prints [statistics] to standard output, or to standard error if standard output contains the picture. */
    private fun printStatistics(form: StatsForm, statistics: Statistics) {
        val text = if (form == StatsForm.JSON) statistics.toJson() + "\n" else StatisticsTable.of(statistics)
        if (request.output == Outputs.STANDARD_OUTPUT) streams.messages.print(text) else streams.print(text)
    }
}
