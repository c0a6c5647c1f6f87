package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Frame.SeenPoint
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderedRows
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.spi.ShadingObserver
import java.io.IOException

/**
 * A frame of samples, and how they become pixels. Created by [SuperSampling]. Immutable, and thread safe if the frame's
 * primitives are.
 *
 * @property sampling the number of samples and their filter
 * @property pixels the pixels that a rendering returns
 */
public class SampledFrame private constructor(
    public val sampling: SuperSampling,
    private val all: Frame,
    public val pixels: Region,
    private val shaded: Frame,
) {
    internal constructor(sampling: SuperSampling, all: Frame, pixels: Region) :
        this(sampling, all, pixels, sampling.points?.let { all.shadedAt(it) } ?: all)

    init {
        val picture = Region(0, 0, all.raster.width / sampling.factor, all.raster.height / sampling.factor)
        require(picture.contains(pixels)) { "$pixels must be within the picture, $picture" }
    }

    /** The samples of the [pixels]; with a filter that is wider than a pixel, also those of the pixels around them. */
    public val frame: Frame = shaded.within(samples())

    private fun samples(): Region {
        val factor = sampling.factor
        val around = (sampling.taps.margin + factor - 1) / factor
        val part = all.raster.region.intersect(
            (pixels.columnStart - around) * factor,
            (pixels.rowStart - around) * factor,
            (pixels.columnEnd + around) * factor,
            (pixels.rowEnd + around) * factor,
        )
        return checkNotNull(part)
    }

    /** Samples a pixel in each direction. */
    internal val factor: Int get() = sampling.factor

    /** Whether each sample is a pixel, so that nothing has to be filtered. */
    private val isPlain: Boolean get() = factor == 1 && isBox

    private val isBox: Boolean get() = sampling.filter == PixelFilter.BOX

    /** Bytes held between the samples and the pixels, while the frame is rendered. */
    internal val filterBytes: Long
        get() = when {
            isPlain -> 0
            isBox -> BoxSink.bytes(pixels)
            else -> FilterSink.bytes(sampling.taps, pixels)
        }

    /**
     * Returns this frame restricted to the pixels of [region]. They are the same as in the whole picture.
     *
     * @throws IllegalArgumentException if [region] is not within the picture
     */
    public fun within(region: Region): SampledFrame = SampledFrame(sampling, all, region, shaded)

    /**
     * Returns what is seen at the pixel in column [x] of row [y], as [Frame.at]: at the one of its samples that wins
     * the depth test, as in AOVs; null if all of them are background.
     *
     * @throws IllegalArgumentException if the pixel is not in [pixels]
     */
    @Throws(InterruptedException::class)
    public fun at(x: Int, y: Int): SeenPoint? {
        require(pixels.contains(x, y)) { "pixel must be within $pixels: ($x, $y)" }
        return frame.at(Region(x * factor, y * factor, (x + 1) * factor, (y + 1) * factor))
    }

    /** Returns this frame with all primitives opaque, see [Frame.asOpaque]. */
    public fun asOpaque(): SampledFrame = SampledFrame(sampling, all.asOpaque(), pixels)

    /** Returns this frame with primitives that report each shading call of a sample, see [Frame.observed]. */
    public fun observed(observer: ShadingObserver): SampledFrame =
        SampledFrame(sampling, all.observed(observer), pixels)

    /**
     * Renders the samples, and passes every row of pixels to [sink]. Throws like [Renderer.render].
     *
     * @return the work, counted in samples
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun render(renderer: Renderer, sink: RowSink): Counters = render(renderer, sink, null)

    /**
     * Renders the pixels, like the other [render]. If there is a [tap], the rows of samples go to what it returns,
     * which passes them on to the sink that it is given.
     */
    internal fun render(renderer: Renderer, sink: RowSink, tap: ((RowSink) -> RowSink)?): Counters {
        if (isPlain) return renderer.render(frame, tapped(sink, tap))
        if (isBox && tap == null) renderer.renderPixels(frame, sampling.factor, sink)?.let { return it }
        val filter = if (isBox) {
            BoxSink(sampling.factor, frame, pixels, sink)
        } else {
            FilterSink(sampling.taps, frame, pixels, sink)
        }
        return renderer.render(frame, tapped(filter, tap))
    }

    private fun tapped(sink: RowSink, tap: ((RowSink) -> RowSink)?): RowSink = if (tap == null) sink else tap(sink)

    /** Renders the pixels to an image in memory. Throws like the other [render]. */
    @Throws(InterruptedException::class)
    public fun render(renderer: Renderer): Image {
        val collector = Image.Collector(pixels)
        return collector.toImage(render(renderer, collector))
    }

    /** Returns the rows of pixels that [renderer] computes, to be read one by one. */
    public fun rows(renderer: Renderer): RenderedRows = RenderedRows(pixels.width) { render(renderer, it) }

    override fun toString(): String = "SampledFrame($sampling, $pixels of $all)"
}
