package dev.lazyz.scenes.writers.imageio

import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SampledFrame
import java.awt.Image
import java.awt.Point
import java.awt.Rectangle
import java.awt.image.BufferedImage
import java.awt.image.ColorModel
import java.awt.image.DataBufferInt
import java.awt.image.Raster
import java.awt.image.RenderedImage
import java.awt.image.SampleModel
import java.awt.image.WritableRaster
import java.io.IOException
import java.io.InterruptedIOException
import java.io.UncheckedIOException
import java.util.Vector

/**
 * A picture as an image of `java.desktop` that is rendered where it is read, so that it can be larger than memory.
 *
 * ```
 * ImageIO.write(PulledImage.of(renderer, frame), "png", file)
 * ```
 *
 * Its tiles are bands of whole rows, of about 4 million pixels. A band is rendered when a pixel of it is read, and kept
 * until another one is. So readers that go from the top to the bottom, such as the writers of `javax.imageio`, have
 * each band rendered once; others work, but may take long. Memory: the band, at 4 bytes a pixel, and that of the
 * renderer. Use a renderer with constant memory, such as `TiledRenderer`. Time: that of the rendering, and the set-up
 * of the renderer for each band, which goes through all primitives.
 *
 * The pixel at column 0 and row 0 is the first one of the frame's region. Pixels are as in
 * [BufferedImage.TYPE_INT_ARGB], or, if the background is opaque, as in [BufferedImage.TYPE_INT_RGB], which has no
 * alpha. Exceptions of the renderer are thrown by the method that reads pixels. An [IOException] is the cause of an
 * [UncheckedIOException] then, since [RenderedImage] declares none. If the thread is interrupted, the cause is an
 * [InterruptedIOException], and the interrupt status is set. Thread safe: one thread renders at a time.
 */
public class PulledImage private constructor(
    private val region: Region,
    isOpaque: Boolean,
    private val render: (Region, RowSink) -> Unit,
) : RenderedImage {
    private val model = BufferedImage(1, 1, if (isOpaque) BufferedImage.TYPE_INT_RGB else BufferedImage.TYPE_INT_ARGB)
    private val rows = (BAND_PIXELS / region.width).coerceIn(1, region.height)
    private val samples = model.sampleModel.createCompatibleSampleModel(region.width, rows)

    /** The band that was rendered last, and its number. */
    private var band: WritableRaster? = null
    private var number = -1

    override fun getWidth(): Int = region.width

    override fun getHeight(): Int = region.height

    override fun getMinX(): Int = 0

    override fun getMinY(): Int = 0

    override fun getNumXTiles(): Int = 1

    override fun getNumYTiles(): Int = (height + rows - 1) / rows

    override fun getMinTileX(): Int = 0

    override fun getMinTileY(): Int = 0

    override fun getTileWidth(): Int = width

    override fun getTileHeight(): Int = rows

    override fun getTileGridXOffset(): Int = 0

    override fun getTileGridYOffset(): Int = 0

    override fun getColorModel(): ColorModel = model.colorModel

    override fun getSampleModel(): SampleModel = samples

    override fun getSources(): Vector<RenderedImage>? = null

    override fun getProperty(name: String): Any = Image.UndefinedProperty

    override fun getPropertyNames(): Array<String>? = null

    /**
     * Returns the band [tileY]. It has [getTileHeight] rows, also the last one, where those below the picture are
     * black.
     *
     * @throws IndexOutOfBoundsException if there is no such tile
     * @throws UncheckedIOException if the renderer throws an [IOException], or the thread is interrupted
     */
    @Synchronized
    override fun getTile(tileX: Int, tileY: Int): Raster {
        if (tileX != 0 || tileY !in 0 until numYTiles) throw IndexOutOfBoundsException("no tile ($tileX, $tileY)")
        band?.takeIf { number == tileY }?.let { return it }

        // The old band is not needed while the new one is rendered
        band = null
        val pixels = IntArray(width * rows)
        val first = region.rowStart + tileY * rows
        render(region.rows(first, first + rows), pixels)
        val origin = Point(0, tileY * rows)
        val raster = Raster.createWritableRaster(samples, DataBufferInt(pixels, pixels.size), origin)
        band = raster
        number = tileY
        return raster
    }

    /** Renders [band] into [pixels]. */
    private fun render(band: Region, pixels: IntArray) = try {
        render(band) { y, argb, _, _ -> argb.copyInto(pixels, (y - band.rowStart) * width, 0, width) }
    } catch (e: InterruptedException) {
        Thread.currentThread().interrupt()
        throw UncheckedIOException(InterruptedIOException(e.message).apply { initCause(e) })
    } catch (e: IOException) {
        throw UncheckedIOException(e)
    }

    /** Returns all pixels. Needs memory for them. Throws like [getTile]. */
    override fun getData(): Raster = getData(Rectangle(width, height))

    /** Returns the pixels of [rect]. If it is within a band, they are not copied. Throws like [getTile]. */
    @Synchronized
    override fun getData(rect: Rectangle): Raster {
        if (rect.y / rows == (rect.y + rect.height - 1) / rows) {
            val tile = getTile(0, rect.y / rows)
            return tile.createChild(rect.x, rect.y, rect.width, rect.height, rect.x, rect.y, null)
        }
        val all = samples.createCompatibleSampleModel(rect.width, rect.height)
        return copyData(Raster.createWritableRaster(all, Point(rect.x, rect.y)))
    }

    /**
     * Copies the pixels of the area of [raster] into it, or of the whole image into a new raster if it is null. Throws
     * like [getTile].
     */
    @Synchronized
    override fun copyData(raster: WritableRaster?): WritableRaster {
        val to = raster ?: Raster.createWritableRaster(samples.createCompatibleSampleModel(width, height), null)
        val area = to.bounds.intersection(Rectangle(width, height))
        for (tileY in area.y / rows..(area.y + area.height - 1) / rows) {
            val part = area.intersection(Rectangle(0, tileY * rows, width, rows))
            val tile = getTile(0, tileY)
            to.setRect(tile.createChild(part.x, part.y, part.width, part.height, part.x, part.y, null))
        }
        return to
    }

    override fun toString(): String = "PulledImage($region, bands of $rows rows)"

    public companion object {
        private const val BAND_PIXELS = 1 shl 22

        /** Returns the image that [renderer] computes of [frame]. */
        @JvmStatic
        public fun of(renderer: Renderer, frame: Frame): PulledImage =
            PulledImage(frame.region, isOpaque(frame)) { band, sink -> renderer.render(frame.within(band), sink) }

        /** Returns the image of pixels that [renderer] computes of [frame]. */
        @JvmStatic
        public fun of(renderer: Renderer, frame: SampledFrame): PulledImage =
            PulledImage(frame.pixels, isOpaque(frame.frame)) { band, sink -> frame.within(band).render(renderer, sink) }

        private fun isOpaque(frame: Frame) = frame.raster.background.alpha >= 1f
    }
}
