package dev.lazyz.cli.input

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.VerticalGradient

/**
 * A [frame] of samples, and how they become pixels.
 *
 * @param gradient what is behind the pixels, or null
 */
internal class Shot(
    val frame: Frame,
    private val sampling: SuperSampling,
    private val gradient: VerticalGradient? = null,
) {
    /** The pixels of the picture. */
    val region: Region = sampling.pixels(frame.region)

    /** Whether all pixels are opaque: with an opaque background, every sample is. */
    val isOpaque: Boolean get() = gradient != null || frame.raster.background.alpha >= 1f

    /** Renders the frame with [strategy], and passes every row of pixels to [sink]. */
    fun render(strategy: Renderer, sink: RowSink): Counters {
        val height = frame.raster.height / sampling.factor
        return sampling.render(strategy, frame, gradient?.behind(region, height, sink) ?: sink)
    }
}
