package dev.lazyz.cli.input

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.ShadingObserver
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame
import dev.lazyz.aov.AovImages
import dev.lazyz.cli.output.Mistake
import dev.lazyz.filter.PixelFilter
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.VerticalGradient
import dev.lazyz.geometry.UpAxis
import dev.lazyz.planning.MemoryItem
import dev.lazyz.planning.RenderPlan
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.scenes.writers.AlphaChannel

/**
 * A frame of samples, and how they become the pixels of a picture.
 *
 * @param gradient what is behind the pixels, or null
 * @param up the axis of the model that points up in the frame
 */
internal class Shot(
    private val sampled: SampledFrame,
    private val gradient: VerticalGradient? = null,
    private val up: UpAxis = UpAxis.Y,
) {
    /** The samples. */
    val frame: Frame get() = sampled.frame

    /** Samples a pixel in each direction. */
    val factor: Int get() = sampled.sampling.factor

    /** Whether each sample is a pixel, without a filter. */
    val isPlain: Boolean get() = factor == 1 && sampled.sampling.filter == PixelFilter.BOX

    /** The pixels of the picture. */
    val pixels: Region get() = sampled.pixels

    /** Whether files need alpha: with an opaque background, all pixels are opaque. */
    val alpha: AlphaChannel
        get() {
            val isOpaque = gradient != null || frame.raster.background.alpha >= 1f
            return if (isOpaque) AlphaChannel.DROP else AlphaChannel.KEEP
        }

    /** Returns this picture, whose shading calls are reported to [observer]. */
    fun observed(observer: ShadingObserver) = Shot(sampled.observed(observer), gradient, up)

    /** Returns the part of this picture with the pixels of [region]. */
    fun within(region: Region) = Shot(sampled.within(region), gradient, up)

    /** Returns the plan of [planner] with the first of [renderers] that fits, besides [others]. */
    fun plan(planner: RenderPlanner, renderers: List<Renderer>, others: List<MemoryItem>): RenderPlan =
        planner.plan(sampled, renderers, others)

    /** Renders the frame with [strategy], and passes every row of pixels to [sink]. */
    fun render(strategy: Renderer, sink: RowSink): Counters = sampled.render(strategy, before(sink))

    /** Renders the frame in the same way, and computes [aovs], in coordinates of the model. */
    fun render(strategy: Renderer, sink: RowSink, aovs: Set<Aov>): AovImages {
        val all = try {
            AovFrame(sampled, aovs)
        } catch (tooLarge: IllegalArgumentException) {
            throw Mistake("--aov: ${tooLarge.message}, with --region")
        }
        return all.render(strategy, before(sink)).toModel(up)
    }

    /** Returns what comes before [sink]: the gradient, and a check for interrupts, which not every strategy makes. */
    private fun before(sink: RowSink): RowSink {
        val behind = gradient?.behind(pixels, frame.raster.height / factor, sink) ?: sink
        return RowSink { y, argb, depth, primitive ->
            if (Thread.interrupted()) throw InterruptedException("interrupted before row $y")
            behind.row(y, argb, depth, primitive)
        }
    }
}
