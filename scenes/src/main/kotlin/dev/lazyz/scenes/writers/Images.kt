@file:JvmName("Images")

package dev.lazyz.scenes.writers

import dev.lazyz.Image
import dev.lazyz.RowSink
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Path

/**
 * Writes the colours to a PNG file, without an alpha channel if the whole picture is opaque. Java:
 * `Images.writePng(image, path)`.
 *
 * The file appears when it is complete; a failure leaves an old file of the name as it was.
 *
 * @throws IOException if the file cannot be written; the message says which file, why, and what to do
 */
public fun Image.writePng(path: Path): Unit = ImageFiles.write(this, path, ImageFormat.PNG)

/**
 * Writes the colours as a PNG to [output], without an alpha channel if the whole picture is opaque. Flushes the stream and
 * leaves it open. Java: `Images.writePng(image, output)`.
 *
 * @throws IOException if the stream does not take it
 */
public fun Image.writePng(output: OutputStream): Unit = ImageFiles.write(this, output)

/** Returns the colours as the bytes of a PNG file, see [writePng]. Java: `Images.toPng(image)`. */
public fun Image.toPng(): ByteArray = ByteArrayOutputStream().also { writePng(it) }.toByteArray()

/**
 * Writes the colours to a binary PPM file, see [PpmSink]: alpha is dropped. Otherwise as [writePng].
 *
 * @throws IOException if the file cannot be written; the message says which file, why, and what to do
 */
public fun Image.writePpm(path: Path): Unit = ImageFiles.write(this, path, ImageFormat.PPM)

/**
 * Writes the depths to a PFM file, see [PfmSink]: 0 near, 1 far, +Infinity where there is nothing. Otherwise as
 * [writePng].
 *
 * @throws IOException if the file cannot be written; the message says which file, why, and what to do
 */
public fun Image.writePfm(path: Path): Unit = ImageFiles.write(this, path, ImageFormat.PFM)

/** Hands all rows to [sink], from the top; for a sink that writes somewhere else than to a file. */
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
