package dev.lazyz.cli.render

import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.output.Statistics
import dev.lazyz.cli.output.StatisticsTable
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Tally
import dev.lazyz.cli.strategies.MemoryNeed
import dev.lazyz.cli.strategies.StrategyChoice

/** One run of `zcli render`: input, frame, strategy, rows to all sinks at once, statistics. */
internal class RenderJob(private val request: RenderRequest, private val streams: Streams) {
    fun run() {
        // Find the user's mistakes before the work begins
        val source = FrameSource(request.subject, streams)
        val choice = StrategyChoice(request.strategy, request.choices)
        val outputs = Outputs(request, source.input, streams)

        // Read, set up, and see who can render it
        val loaded = source.load()
        val start = System.nanoTime()
        val frame = source.frame(loaded)
        val strategy = choice.strategyFor(frame)
        if (request.isExplained) streams.note(choice.explain(strategy, frame))
        MemoryNeed.check(strategy, frame.region)

        // Render to all outputs at once
        streams.progress("rendering ${frame.primitives.size} primitives with ${strategy.id} ...")
        val tally = Tally(frame.width, request.stats != null)
        val counters = outputs.write(frame, tally) { sink -> strategy.render(frame, sink) }
        val nanoseconds = System.nanoTime() - start

        // Tell
        if (tally.visible == 0L) streams.nothingIsVisible()
        outputs.describe(frame.region)
        val form = request.stats ?: return
        val name = source.input.name
        tell(form, Statistics(name, strategy, frame.region, counters, tally, loaded.warnings.size, nanoseconds))
    }

    /** Statistics go where a script can read them, and never into the picture. */
    private fun tell(form: StatsForm, statistics: Statistics) {
        val text = if (form == StatsForm.JSON) statistics.toJson() + "\n" else StatisticsTable.of(statistics)
        if (request.output == Outputs.STANDARD_OUTPUT) streams.messages.print(text) else streams.print(text)
    }
}
