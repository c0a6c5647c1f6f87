package dev.lazyz.scenes.writers

import dev.lazyz.Image
import dev.lazyz.RowSink
import java.io.IOException
import java.io.OutputStream
import java.nio.channels.Channels
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.util.function.Function

/**
 * Writes pictures to files, row by row as they are rendered.
 *
 * A file appears when it is complete: until then an old file of the name stays, and after a failure nothing is left
 * behind. To write a picture that is in memory, see [writePng] and its like.
 */
public object ImageFiles {
    /**
     * Lets [produce] write a picture's rows to [path].
     *
     * For example `ImageFiles.write(path, frame.width, frame.height) { sink -> renderer.render(frame, sink) }`. Memory: a
     * few rows.
     *
     * @param width number of columns
     * @param height number of rows
     * @param format the kind of file; by default what the ending of the file name says
     * @param alpha whether a PNG has an alpha channel; other formats have none
     * @param produce renders to the sink it is given, all rows from the top
     * @return what [produce] returns
     * @throws IllegalArgumentException if [format] is left out and the ending says nothing
     * @throws IOException if the file cannot be written; the message says which file, why, and what to do
     */
    @JvmStatic
    @JvmOverloads
    public fun <R> write(
        path: Path,
        width: Int,
        height: Int,
        format: ImageFormat = formatOf(path),
        alpha: AlphaChannel = AlphaChannel.KEEP,
        produce: Function<RowSink, R>,
    ): R = AtomicFile.write(path) { channel -> write(channel, width, height, format, alpha, produce) }

    /**
     * Returns the format that the ending of [path] stands for.
     *
     * @throws IllegalArgumentException if it stands for none
     */
    @JvmStatic
    public fun formatOf(path: Path): ImageFormat {
        val format = ImageFormat.ofFileName(path.toString())
        return requireNotNull(format) {
            val known = ImageFormat.entries.flatMap { it.extensions }.joinToString { ".$it" }
            "cannot tell the format of $path: it must end in one of $known"
        }
    }

    internal fun write(image: Image, path: Path, format: ImageFormat) {
        AtomicFile.write(path) { write(it, image.width, image.height, format, alpha(image), image::sendTo) }
    }

    /** Writes a PNG to [output], and leaves it open. */
    internal fun write(image: Image, output: OutputStream) {
        PngSink(KeptOpen(output), image.width, image.height, alpha(image)).use(image::sendTo)
    }

    private fun alpha(image: Image): AlphaChannel =
        if (image.argb.all { it ushr 24 == 0xFF }) AlphaChannel.DROP else AlphaChannel.KEEP

    private fun <R> write(
        channel: FileChannel,
        width: Int,
        height: Int,
        format: ImageFormat,
        alpha: AlphaChannel,
        produce: Function<RowSink, R>,
    ): R = when (format) {
        ImageFormat.PNG -> PngSink(Channels.newOutputStream(channel), width, height, alpha).use { produce.apply(it) }
        ImageFormat.PPM -> PpmSink(Channels.newOutputStream(channel), width, height).use { produce.apply(it) }
        ImageFormat.PFM -> PfmSink(channel, width, height).use { produce.apply(it) }
    }
}

/** Flushes [output] where others would close it. */
private class KeptOpen(private val output: OutputStream) : OutputStream() {
    override fun write(byte: Int) = output.write(byte)

    override fun write(bytes: ByteArray, offset: Int, length: Int) = output.write(bytes, offset, length)

    override fun flush() = output.flush()

    override fun close() = output.flush()
}
