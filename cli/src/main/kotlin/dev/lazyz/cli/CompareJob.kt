package dev.lazyz.cli

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Renderer

/** One run of `zcli compare`: one frame, all strategies one after the other, each held against the first. */
internal class CompareJob(private val request: CompareRequest, private val streams: Streams) {
    /** The first picture that is complete; the only one that is kept. */
    private var reference: Reference? = null

    fun run(): Comparison {
        // Find the user's mistakes before the work begins
        val source = FrameSource(request.subject, streams)
        val strategies = strategies()

        // Read, set up, and see whether it fits
        val loaded = source.load()
        val frame = source.frame(loaded)
        val able = strategies.filter { canRender(it, frame) }
        if (able.isEmpty()) throw Mistake(noneBlends())
        for (strategy in able) MemoryNeed.check(strategy, frame.region, kept = BYTES_PER_PIXEL)

        // Render with one after the other
        val outcomes = strategies.map { strategy ->
            strategy.id to if (strategy in able) outcome(strategy, frame) else Outcome.NotBlending
        }
        if (reference?.image?.visible == 0) streams.warning("nothing is visible: the picture is all background")
        return Comparison(source.input.name, frame, request.repeat, loaded.warnings.size, reference, outcomes)
    }

    private fun strategies(): List<Renderer> {
        val chosen = request.strategies.map { Strategies.find(it) }.ifEmpty { Strategies.all() }

        // A flag that nobody heeds would be a comparison of nothing
        val heeded = chosen.flatMap { it.capabilities }.toSet()
        val missing = Strategies.missing(request.choices.needs, heeded)
        if (missing != null) throw Mistake("no compared strategy heeds $missing\nSee 'zcli strategies --long'.")
        return chosen.map { request.choices.applyTo(it) }
    }

    private fun canRender(strategy: Renderer, frame: Frame): Boolean =
        !frame.hasTranslucency || Capability.TRANSPARENCY in strategy.capabilities

    private fun noneBlends(): String = "the scene is translucent, and no compared strategy blends " +
        "(${Strategies.whoDoes(Capability.TRANSPARENCY)})\nCompare others, or compare it as opaque with --opaque."

    private fun outcome(strategy: Renderer, frame: Frame): Outcome = try {
        rendered(strategy, frame)
    } catch (failure: Throwable) {
        // Whatever a strategy throws, the others shall have their turn
        Outcome.Failed(failure)
    }

    private fun rendered(strategy: Renderer, frame: Frame): Outcome {
        val times = LongArray(request.repeat)
        var counters = Counters()
        var difference: Difference? = null
        for (i in times.indices) {
            streams.progress("rendering with ${strategy.id}, ${i + 1} of ${request.repeat} ...")

            // Keep the very first picture, and hold all others against it, row by row
            val known = reference?.image
            val collector = if (known == null) Image.Collector(frame.region) else null
            val comparison = known?.let { RowComparison(it) }
            val rows = CompleteRows(frame.region, listOfNotNull(collector, comparison).single())

            val start = System.nanoTime()
            counters = strategy.render(frame, rows)
            times[i] = System.nanoTime() - start
            rows.requireComplete()
            if (collector != null) reference = Reference(strategy.id, collector.toImage(counters))
            difference = difference ?: comparison?.difference
        }
        times.sort()
        return Outcome.Rendered(counters, times[times.size / 2], difference)
    }

    private companion object {
        /** Colour, depth and primitive of the picture that is kept. */
        const val BYTES_PER_PIXEL = 12L
    }
}
