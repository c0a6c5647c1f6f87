package dev.lazyz.cli.compare

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.world.camera.FittedViewpoint.View

/**
 * Renders frames with all strategies of [request], one after the other, and compares each picture with the first.
 *
 * @param kept bytes for each pixel that the caller keeps besides
 * @throws Mistake if a strategy is not known, or an option is not supported by any strategy
 */
internal class CompareJob(
    private val request: CompareRequest,
    private val streams: Streams,
    private val kept: Long = 0,
) {
    private val strategies = strategies()

    /** Compares pictures of the scene [loaded] from [source], from the side [view] unless it is null. */
    fun compare(source: FrameSource, loaded: LoadedScene, view: View? = null): Comparison {
        val shot = source.frame(loaded, request.choices.options(), view, name = view?.name?.lowercase())
        val frame = shot.frame
        val able = strategies.filter { canRender(it, frame) }
        if (able.isEmpty()) throw Mistake(noneBlends())
        for (strategy in able) {
            Strategies.requireMemory(strategy, frame.region, kept = BYTES_PER_PIXEL + kept, aa = shot.factor)
        }

        // Render with one after the other, and so on for each repetition: what disturbs the machine, and Java's
        // warm-up, then meet all strategies alike
        val round = Round(shot)
        val runs = strategies.map { if (it in able) Run(it) else null }
        for (number in 1..request.repeat) runs.forEach { it?.render(number, round) }
        val outcomes = strategies.zip(runs) { strategy, run -> strategy.id to (run?.outcome() ?: Outcome.NotBlending) }
        val warnings = loaded.warnings.size
        return Comparison(source.input.name, view, shot, request.repeat, warnings, round.reference, outcomes)
    }

    private fun strategies(): List<Renderer> {
        val chosen = request.strategies.map { Strategies.find(it) }.ifEmpty { Strategies.all() }

        // If no strategy supports an option, the comparison would not measure what the user wanted
        val supported = chosen.flatMap { it.capabilities }.toSet()
        val missing = Strategies.missing(request.choices.needs, supported)
        if (missing != null) throw Mistake("no compared strategy supports $missing\nSee 'zcli strategies --long'.")
        return chosen.map { request.choices.applyTo(it) }
    }

    private fun canRender(strategy: Renderer, frame: Frame): Boolean =
        !frame.hasTranslucency || Capability.TRANSPARENCY in strategy.capabilities

    private fun noneBlends(): String = "the scene is translucent, and no compared strategy blends " +
        "(${Strategies.supporters(Capability.TRANSPARENCY)})\nCompare others, or compare it as opaque with --opaque."

    /** One frame, and the first complete picture of it. No other picture is kept in memory. */
    private class Round(val shot: PictureFrame) {
        var reference: Reference? = null
    }

    /** The renderings of one frame with [strategy]. */
    private inner class Run(private val strategy: Renderer) {
        private val times = LongArray(request.repeat)
        private var counters = Counters.NONE
        private var difference: Difference? = null
        private var failure: Throwable? = null

        /** Renders for the time [number], from 1, unless it has failed before. */
        fun render(number: Int, round: Round) {
            if (failure != null) return
            streams.progress("rendering with ${strategy.id}, $number of ${request.repeat} ...")
            try {
                rendered(number, round)
            } catch (ended: InterruptedException) {
                throw ended
            } catch (failure: Throwable) {
                // Continue with the other strategies
                this.failure = failure
            }
        }

        private fun rendered(number: Int, round: Round) {
            // Keep the first picture, and compare all others with it, row by row
            val shot = round.shot
            val known = round.reference?.image
            val collector = if (known == null) Image.Collector(shot.pixels) else null
            val comparison = known?.let { RowComparison(it) }
            val rows = CompleteRows(shot.pixels, listOfNotNull(collector, comparison).single())

            val start = System.nanoTime()
            counters = shot.render(strategy, rows)
            times[number - 1] = System.nanoTime() - start
            rows.requireComplete()
            if (collector != null) round.reference = Reference(strategy.id, collector.toImage(counters))
            difference = difference ?: comparison?.difference
        }

        fun outcome(): Outcome {
            failure?.let { return Outcome.Failed(it) }
            times.sort()
            return Outcome.Rendered(counters, times[times.size / 2], difference)
        }
    }

    private companion object {
        /** Size of colour, depth and primitive id of a pixel of the picture that is kept. */
        const val BYTES_PER_PIXEL = 12L
    }
}

/**
 * The options of `zcli compare`.
 *
 * @property strategies ids; if empty, all strategies
 * @property views the sides to look from, one after the other; if empty, the camera of the input
 * @property blanks what happens if a picture is blank
 */
internal class CompareRequest(
    val strategies: List<String>,
    val choices: Choices,
    val repeat: Int,
    val views: List<View>,
    val blanks: BlankPictures,
)
