package dev.lazyz.cli.compare

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.Shot
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.MemoryNeed
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.world.View

/**
 * Renders frames with all strategies of [request], one after the other, and compares each picture with the first.
 *
 * @param kept bytes for each pixel that the caller keeps besides
 * @throws Mistake if a strategy is not known, or a flag is not supported by any strategy
 */
internal class CompareJob(
    private val request: CompareRequest,
    private val streams: Streams,
    private val kept: Long = 0,
) {
    private val strategies = strategies()

    /** Compares pictures of the scene [loaded] from [source], from the side [view] unless it is null. */
    fun compare(source: FrameSource, loaded: LoadedScene, view: View? = null): Comparison {
        val shot = source.frame(loaded, request.choices.options(), view)
        val frame = shot.frame
        val able = strategies.filter { canRender(it, frame) }
        if (able.isEmpty()) throw Mistake(noneBlends())
        for (strategy in able) {
            MemoryNeed.check(strategy, frame.region, kept = BYTES_PER_PIXEL + kept, aa = shot.factor)
        }

        // Render with one after the other
        val round = Round(shot)
        val outcomes = strategies.map { strategy ->
            strategy.id to if (strategy in able) round.outcome(strategy) else Outcome.NotBlending
        }
        val warnings = loaded.warnings.size
        return Comparison(source.input.name, view, shot, request.repeat, warnings, round.reference, outcomes)
    }

    private fun strategies(): List<Renderer> {
        val chosen = request.strategies.map { Strategies.find(it) }.ifEmpty { Strategies.all() }

        // If no strategy supports a flag, the comparison would not measure what the user wanted
        val supported = chosen.flatMap { it.capabilities }.toSet()
        val missing = Strategies.missing(request.choices.needs, supported)
        if (missing != null) throw Mistake("no compared strategy supports $missing\nSee 'zcli strategies --long'.")
        return chosen.map { request.choices.applyTo(it) }
    }

    private fun canRender(strategy: Renderer, frame: Frame): Boolean =
        !frame.hasTranslucency || Capability.TRANSPARENCY in strategy.capabilities

    private fun noneBlends(): String = "the scene is translucent, and no compared strategy blends " +
        "(${Strategies.supporters(Capability.TRANSPARENCY)})\nCompare others, or compare it as opaque with --opaque."

    /** One frame, rendered with one strategy after the other. */
    private inner class Round(private val shot: Shot) {
        /** The first complete picture. No other picture is kept in memory. */
        var reference: Reference? = null
            private set

        fun outcome(strategy: Renderer): Outcome = try {
            rendered(strategy)
        } catch (failure: Throwable) {
            // Continue with the other strategies
            Outcome.Failed(failure)
        }

        private fun rendered(strategy: Renderer): Outcome {
            val times = LongArray(request.repeat)
            var counters = Counters.NONE
            var difference: Difference? = null
            for (i in times.indices) {
                streams.progress("rendering with ${strategy.id}, ${i + 1} of ${request.repeat} ...")

                // Keep the first picture, and compare all others with it, row by row
                val known = reference?.image
                val collector = if (known == null) Image.Collector(shot.pixels) else null
                val comparison = known?.let { RowComparison(it) }
                val rows = CompleteRows(shot.pixels, listOfNotNull(collector, comparison).single())

                val start = System.nanoTime()
                counters = shot.render(strategy, rows)
                times[i] = System.nanoTime() - start
                rows.requireComplete()
                if (collector != null) reference = Reference(strategy.id, collector.toImage(counters))
                difference = difference ?: comparison?.difference
            }
            times.sort()
            return Outcome.Rendered(counters, times[times.size / 2], difference)
        }
    }

    private companion object {
        /** Size of colour, depth and primitive id of a pixel of the picture that is kept. */
        const val BYTES_PER_PIXEL = 12L
    }
}
