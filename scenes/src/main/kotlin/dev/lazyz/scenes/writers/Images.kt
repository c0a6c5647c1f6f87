@file:JvmName("Images")

package dev.lazyz.scenes.writers

import dev.lazyz.Image
import dev.lazyz.RowSink
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Path

/**
 * Writes the colours to a PNG file, without an alpha channel if the whole image is opaque. In Java:
 * `Images.writePng(image, path)`.
 *
 * The file appears only when it is complete. If writing fails, an old file with the same name stays unchanged.
 *
 * @throws IOException if the file cannot be written; the message states which file, why, and what to do
 */
@Throws(IOException::class)
public fun Image.writePng(path: Path): Unit = ImageFiles.write(this, path, ImageFormat.PNG)

/**
 * Writes the colours as a PNG to [output], without an alpha channel if the whole image is opaque. Flushes the stream
 * and does not close it. In Java: `Images.writePng(image, output)`.
 *
 * @throws IOException if writing to the stream fails
 */
@Throws(IOException::class)
public fun Image.writePng(output: OutputStream): Unit = ImageFiles.write(this, output)

/** Returns the colours as the bytes of a PNG file, see [writePng]. In Java: `Images.toPng(image)`. */
public fun Image.toPng(): ByteArray = ByteArrayOutputStream().also { writePng(it) }.toByteArray()

/**
 * Writes the colours to a binary PPM file, see [PpmSink]: alpha is dropped. Otherwise like [writePng].
 *
 * @throws IOException if the file cannot be written; the message states which file, why, and what to do
 */
@Throws(IOException::class)
public fun Image.writePpm(path: Path): Unit = ImageFiles.write(this, path, ImageFormat.PPM)

/**
 * Writes the depths to a PFM file, see [PfmSink]: 0 near, 1 far, +Infinity for the background. Otherwise like
 * [writePng].
 *
 * @throws IOException if the file cannot be written; the message states which file, why, and what to do
 */
@Throws(IOException::class)
public fun Image.writePfm(path: Path): Unit = ImageFiles.write(this, path, ImageFormat.PFM)

/**
 * Returns a copy of the colours as a `java.desktop` image of type [BufferedImage.TYPE_INT_ARGB]. In Java:
 * `Images.toBufferedImage(image)`.
 */
public fun Image.toBufferedImage(): BufferedImage {
    val picture = BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB)
    picture.raster.setDataElements(0, 0, width, height, argb)
    return picture
}

/**
 * Passes all rows to [sink], from the top. For custom sinks, which need not write to a file.
 *
 * @throws IOException if the sink throws it
 */
@Throws(IOException::class)
public fun Image.sendTo(sink: RowSink) {
    val argb = IntArray(width)
    val depth = IntArray(width)
    val primitive = IntArray(width)
    for (y in 0 until height) {
        System.arraycopy(this.argb, y * width, argb, 0, width)
        System.arraycopy(this.depth, y * width, depth, 0, width)
        System.arraycopy(this.primitive, y * width, primitive, 0, width)
        sink.row(region.rowStart + y, argb, depth, primitive)
    }
}

/** Produces the rows of an image, for example by rendering: `sink -> renderer.render(frame, sink)`. */
public fun interface RowProducer<R> {
    /**
     * Passes every row to [sink], from the top.
     *
     * @return any result, for example the counters of the rendering
     * @throws IOException if the sink throws it
     * @throws InterruptedException if the rendering is interrupted
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun sendTo(sink: RowSink): R
}
