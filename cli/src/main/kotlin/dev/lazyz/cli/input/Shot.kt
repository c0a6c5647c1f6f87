package dev.lazyz.cli.input

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.VerticalGradient
import dev.lazyz.scenes.writers.AlphaChannel

/**
 * A frame of samples, and how they become the pixels of a picture.
 *
 * @param gradient what is behind the pixels, or null
 */
internal class Shot(private val sampled: SampledFrame, private val gradient: VerticalGradient? = null) {
    /** The samples. */
    val frame: Frame get() = sampled.frame

    /** Samples a pixel in each direction. */
    val factor: Int get() = sampled.sampling.factor

    /** The pixels of the picture. */
    val pixels: Region get() = sampled.pixels

    /** Whether files need alpha: with an opaque background, all pixels are opaque. */
    val alpha: AlphaChannel
        get() {
            val isOpaque = gradient != null || frame.raster.background.alpha >= 1f
            return if (isOpaque) AlphaChannel.DROP else AlphaChannel.KEEP
        }

    /** Renders the frame with [strategy], and passes every row of pixels to [sink]. */
    fun render(strategy: Renderer, sink: RowSink): Counters {
        val height = frame.raster.height / factor
        return sampled.render(strategy, gradient?.behind(pixels, height, sink) ?: sink)
    }
}
