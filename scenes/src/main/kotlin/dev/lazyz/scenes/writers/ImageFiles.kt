package dev.lazyz.scenes.writers

import dev.lazyz.Image
import dev.lazyz.RowSink
import java.io.IOException
import java.io.OutputStream
import java.nio.channels.Channels
import java.nio.channels.FileChannel
import java.nio.file.Path

/**
 * Writes images to files, row by row while they are rendered.
 *
 * A file appears only when it is complete: until then an old file with the same name stays, and a failure leaves no
 * partial file. To write an image that is in memory, see [writePng] and the similar functions.
 */
public object ImageFiles {
    /**
     * Writes the rows that [produce] renders to an image file at [path].
     *
     * For example `ImageFiles.write(path, frame.width, frame.height) { sink -> renderer.render(frame, sink) }`.
     * Memory: see the sink of the format, for example [PngSink].
     *
     * @param width number of columns
     * @param height number of rows
     * @param format the file format; by default determined by the file name extension
     * @param alpha whether a PNG has an alpha channel; other formats have none
     * @param produce renders to the sink it is given, all rows from the top
     * @return what [produce] returns
     * @throws IllegalArgumentException if [format] is omitted and the extension is unknown
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do
     * @throws InterruptedException if the thread is interrupted while it renders or writes
     */
    @JvmStatic
    @JvmOverloads
    @Throws(InterruptedException::class, IOException::class)
    public fun <R> write(
        path: Path,
        width: Int,
        height: Int,
        format: ImageFormat = formatOf(path),
        alpha: AlphaChannel = AlphaChannel.KEEP,
        produce: RowProducer<R>,
    ): R = AtomicFile.rendering {
        AtomicFile.write(path) { channel -> write(channel, width, height, format, alpha, produce) }
    }

    /**
     * Returns the format for the file name extension of [path].
     *
     * @throws IllegalArgumentException if the extension is unknown
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

    /** Writes a PNG to [output] without closing it. */
    internal fun write(image: Image, output: OutputStream) {
        PngSink(NonClosingStream(output), image.width, image.height, alpha(image)).use(image::sendTo)
    }

    private fun alpha(image: Image): AlphaChannel =
        if (image.argb.all { it ushr 24 == 0xFF }) AlphaChannel.DROP else AlphaChannel.KEEP

    private fun <R> write(
        channel: FileChannel,
        width: Int,
        height: Int,
        format: ImageFormat,
        alpha: AlphaChannel,
        produce: RowProducer<R>,
    ): R = when (format) {
        ImageFormat.PNG -> PngSink(Channels.newOutputStream(channel), width, height, alpha).use { produce.sendTo(it) }
        ImageFormat.PPM -> PpmSink(Channels.newOutputStream(channel), width, height).use { produce.sendTo(it) }
        ImageFormat.PFM -> PfmSink(channel, width, height).use { produce.sendTo(it) }
    }
}

/** Flushes [output] on [close] instead of closing it. */
internal class NonClosingStream(private val output: OutputStream) : OutputStream() {
    override fun write(byte: Int) = output.write(byte)

    override fun write(bytes: ByteArray, offset: Int, length: Int) = output.write(bytes, offset, length)

    override fun flush() = output.flush()

    override fun close() = output.flush()
}

/**
 * The file formats that an image can be written to.
 *
 * @property id lower-case name, used on command lines
 * @property extensions file name extensions, lower case, without a dot
 */
public enum class ImageFormat(public val id: String, public val extensions: List<String>) {
    /** Portable Network Graphics: colours, lossless compression, see [PngSink]. */
    PNG("png", listOf("png")),

    /** Portable pixmap: colours, uncompressed, see [PpmSink]. */
    PPM("ppm", listOf("ppm")),

    /** Portable float map: depths, uncompressed, see [PfmSink]. */
    PFM("pfm", listOf("pfm")),
    ;

    public companion object {
        /** Returns the format that a file name's extension belongs to, or null. */
        @JvmStatic
        public fun ofFileName(name: String): ImageFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}
