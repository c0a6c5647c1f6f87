package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderedRows
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.ShadingRate
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
public class SampledFrame internal constructor(
    public val sampling: SuperSampling,
    private val all: Frame,
    public val pixels: Region,
) {
    init {
        val picture = Region(0, 0, all.raster.width / sampling.factor, all.raster.height / sampling.factor)
        require(picture.contains(pixels)) { "$pixels must be within the picture, $picture" }
    }

    /** The samples of the [pixels]; with a filter that is wider than a pixel, also those of the pixels around them. */
    public val frame: Frame = all.within(samples())

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

    /** Whether each sample is a pixel, so that nothing has to be filtered. */
    private val isPlain: Boolean get() = sampling.factor == 1 && isBox

    private val isBox: Boolean get() = sampling.filter == PixelFilter.BOX

    private val isShadedLate: Boolean get() = sampling.rate == ShadingRate.PIXEL && sampling.factor > 1

    /** Bytes held between the samples and the pixels, while the frame is rendered. */
    internal val filterBytes: Long
        get() {
            val filter = when {
                isPlain -> 0
                isBox -> BoxSink.bytes(pixels)
                else -> FilterSink.bytes(sampling.taps, pixels)
            }
            if (!isShadedLate) return filter
            val rows = if (isBox) 0 else SampleRows.bytes(sampling.factor, frame.width)
            return filter + rows + PixelShading.bytes(frame, sampling.factor)
        }

    /**
     * Returns this frame restricted to the pixels of [region]. They are the same as in the whole picture.
     *
     * @throws IllegalArgumentException if [region] is not within the picture
     */
    public fun within(region: Region): SampledFrame = SampledFrame(sampling, all, region)

    /** Returns this frame with all primitives opaque, see [Frame.asOpaque]. */
    public fun asOpaque(): SampledFrame = SampledFrame(sampling, all.asOpaque(), pixels)

    /** Returns this frame with primitives that report each shading call of a sample, see [Frame.observed]. */
    public fun observed(observer: ShadingObserver): SampledFrame =
        SampledFrame(sampling, all.observed(observer), pixels)

    /**
     * Renders the samples, and passes every row of pixels to [sink]. Throws like [Renderer.render].
     *
     * @return the work, counted in samples
     * @throws IllegalArgumentException if the shading rate is [ShadingRate.PIXEL], and the frame has translucent
     *   primitives
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun render(renderer: Renderer, sink: RowSink): Counters = render(renderer, sink, null)

    /**
     * Renders the pixels, like the other [render]. If there is a [tap], the rows of samples go to what it returns,
     * which passes them on to the sink that it is given.
     */
    internal fun render(renderer: Renderer, sink: RowSink, tap: ((RowSink) -> RowSink)?): Counters {
        if (isPlain) return renderer.render(frame, tapped(sink, tap))
        require(!isShadedLate || !frame.hasTranslucency) {
            "translucent primitives are shaded at every sample: use ShadingRate.SAMPLE"
        }
        if (isBox && tap == null) {
            renderer.renderPixels(frame, sampling.factor, sampling.rate, sink)?.let { return it }
        }
        val box = if (isBox) BoxSink(sampling.factor, frame, pixels, sink) else null
        val filter: RowSink = box ?: FilterSink(sampling.taps, frame, pixels, sink)
        if (!isShadedLate) return renderer.render(frame, tapped(filter, tap))

        // Find the visible primitives first, without their colours
        val colors = box ?: SampleRows(sampling.factor, frame.width, filter)
        val shading = PixelShading(frame, sampling.factor, colors)
        return shading.counted(renderer.render(frame.unshaded(), tapped(shading, tap)))
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
