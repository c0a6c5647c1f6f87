package dev.lazyz.scenes.images

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.imageio.ImageReader
import javax.imageio.event.IIOReadProgressListener
import javax.imageio.stream.MemoryCacheImageInputStream

/**
 * Decodes image files with the readers of the JDK, PNG, JPEG, TIFF, BMP, GIF and WBMP, of several images the first;
 * WebP; KTX2; and TGA. The readers see only the [NeededParts] of a file.
 */
internal object ImageDecoder {
    /** The maximum length of an array. */
    private const val MAX_PIXELS = Int.MAX_VALUE - 8L

    /**
     * The maximum number of pixels per byte of a file. PNG compression reaches at most about 1032:1 (RFC 1951), with
     * 8 pixels of 1 bit per byte. A header that claims more is malicious or damaged, and decoding it would fill
     * memory before it failed.
     */
    private const val MAX_PIXELS_PER_BYTE = 16384L

    /**
     * Returns what [convert] makes of the image in [bytes], or null if it cannot be decoded.
     *
     * @param admit is given the number of pixels before they are decoded, and the bytes that the decoder needs for
     *   them; throws [SceneFormatException] if they are too many
     * @param look called for each row that is decoded; throws [SceneFormatException] to end the decoding
     * @throws OutOfMemoryError if the memory is too small for the image, even if the reader hides that
     */
    fun <T> decode(
        bytes: ByteArray,
        admit: (pixels: Long, bytes: Long) -> Unit,
        look: () -> Unit = {},
        convert: (BufferedImage) -> T,
    ): T? = try {
        NeededParts.of(bytes)?.let { read(it, admit, look, convert) }
    } catch (ended: SceneFormatException) {
        throw ended
    } catch (e: IOException) {
        // Some readers of the JDK wrap what ends them
        generateSequence<Throwable>(e) { it.cause }.firstOrNull { it is SceneFormatException }?.let { throw it }
        requireMemory(e)
    } catch (e: RuntimeException) {
        // Some decoders of the JDK fail on a damaged file with an index out of bounds or a negative size
        requireMemory(e)
    } catch (_: LinkageError) {
        // A reduced JDK without java.desktop
        null
    }

    /** Throws the [OutOfMemoryError] that is the cause of [failure]; otherwise returns null. */
    private fun requireMemory(failure: Exception): Nothing? {
        generateSequence<Throwable>(failure) { it.cause }.firstOrNull { it is OutOfMemoryError }?.let { throw it }
        return null
    }

    private fun <T> read(
        bytes: ByteArray,
        admit: (pixels: Long, bytes: Long) -> Unit,
        look: () -> Unit,
        convert: (BufferedImage) -> T,
    ): T? {
        val ktx2 = Ktx2Image.of(bytes)
        if (ktx2 != null) {
            if (ktx2.pixels > MAX_PIXELS) return null
            admit(ktx2.pixels, ktx2.memory)
            return convert(ktx2.decode(look))
        }
        val isWebP = WebPImage.isWebP(bytes)
        val reader = if (isWebP) WebPImage.reader(bytes, look) else readerOf(bytes)
        if (reader == null) {
            return TgaImage.of(bytes)?.let {
                admit(it.pixels, Loading.DECODING_BYTES * it.pixels)
                convert(it.decode())
            }
        }
        try {
            val pixels = reader.getWidth(0).toLong() * reader.getHeight(0)
            if (pixels > MAX_PIXELS || pixels > bytes.size * MAX_PIXELS_PER_BYTE) return null
            admit(pixels, if (isWebP) WebPImage.memory(bytes) else Loading.DECODING_BYTES * pixels)
            val rows = Rows(look)
            reader.addIIOReadProgressListener(rows)
            val image = reader.read(0)
            rows.ended?.let { throw it }
            return convert(image)
        } finally {
            reader.dispose()
        }
    }

    /** Returns a reader of the JDK for the file in [bytes], or null. */
    private fun readerOf(bytes: ByteArray): ImageReader? {
        val stream = MemoryCacheImageInputStream(ByteArrayInputStream(bytes))
        val reader = ImageIO.getImageReaders(stream).asSequence().firstOrNull() ?: return null

        // Of the metadata of TIFF, only what is essential; readers of other formats leave out more than that
        reader.setInput(stream, true, reader.originatingProvider?.formatNames.orEmpty().contains("tiff"))
        return reader
    }

    /** Looks after each row whether to go on. Readers in native code cannot be left by an exception. */
    private class Rows(private val look: () -> Unit) : IIOReadProgressListener {
        /** Why the reading was ended, or null. */
        var ended: SceneFormatException? = null
            private set

        override fun imageProgress(source: ImageReader, percentageDone: Float) {
            try {
                look()
            } catch (e: SceneFormatException) {
                ended = e
                source.abort()
            }
        }

        override fun imageStarted(source: ImageReader, imageIndex: Int) = Unit

        override fun imageComplete(source: ImageReader) = Unit

        override fun readAborted(source: ImageReader) = Unit

        override fun sequenceStarted(source: ImageReader, minIndex: Int) = Unit

        override fun sequenceComplete(source: ImageReader) = Unit

        override fun thumbnailStarted(source: ImageReader, imageIndex: Int, thumbnailIndex: Int) = Unit

        override fun thumbnailProgress(source: ImageReader, percentageDone: Float) = Unit

        override fun thumbnailComplete(source: ImageReader) = Unit
    }
}

/**
 * Reads textures from image files: PNG, JPEG, WebP, KTX2, TGA, and the other formats that the JDK reads (TIFF, BMP,
 * GIF, WBMP).
 *
 * Texels are the codes that the file stores, see [Texels]; colour profiles are ignored. The codes of a JPEG are those
 * that the JDK's decoder computes, which can differ between JDKs. Textures have the filter [MipFilter.ANISOTROPIC].
 */
internal object TextureFiles {
    /** How many bytes of a file tell its format. */
    private const val START = 512
    private val avif = listOf("ftypavif", "ftypavis").map { it.toByteArray(Charsets.ISO_8859_1) }

    /** Returns the format of an image that begins with [bytes], and what to do, if it is one that is not read. */
    fun refusal(bytes: ByteArray): String? =
        if (avif.any { it.isAt(bytes, 4) }) "AVIF; save it as PNG, JPEG or WebP" else Ktx2Image.refusal(bytes)

    /** Returns the text of a warning about an image that exists but cannot be decoded, and begins with [bytes]. */
    fun notDecoded(bytes: ByteArray): String = "cannot be decoded and is left out" +
        (refusal(bytes)?.let { ": it is $it" } ?: "; save it as PNG, JPEG or WebP")

    /** As [notDecoded], for the image in [file]. */
    fun notDecoded(file: Path): String = notDecoded(
        try {
            Files.newInputStream(file).use { it.readNBytes(START) }
        } catch (_: IOException) {
            ByteArray(0)
        },
    )

    /** Returns the image in the file [path] as a texture. */
    fun read(path: Path, limits: LoadLimits): Texture {
        val source = Source.ofFile(path, limits)
        return decode(source, source.bytes, path.fileName.toString())
            ?: refusal(source.bytes)?.let { source.fail(null, "cannot be decoded: it is $it") }
            ?: source.fail(null, "is not an image that can be read", "save it as PNG or JPEG")
    }

    /**
     * Returns the image in [bytes], which [source] contains or refers to, as a texture called [name]; null if it
     * cannot be decoded.
     */
    fun decode(source: Source, bytes: ByteArray, name: String): Texture? =
        ImageDecoder.decode(
            bytes, admit = { pixels, memory -> source.loading.texels(source, pixels, memory) },
            look = { source.loading.look(source.name) },
        ) { image ->
            val texels = Texels.of(image) { source.step(image.width) }
            Texture(image.width, image.height, texels, name = name, mipFilter = MipFilter.ANISOTROPIC)
        }

    /**
     * Returns the texture in the file that [reference] names, searched for in [folders]; null, with a warning, if
     * there is no such file or it cannot be decoded. A file is decoded only once, even if its references are spelt
     * differently.
     */
    fun find(source: Source, reference: String, folders: List<Path> = listOfNotNull(source.folder)): Texture? {
        val found = source.references.find(reference, folders)
        if (found.file == null) {
            source.warn("texture ", reference, " ${found.warning}")
            return null
        }
        val texture = ofFile(source, found.file)
        if (texture == null) source.warn("texture ", reference, " ${notDecoded(found.file)}")
        return texture
    }

    /** Returns the texture in [file], or null if it cannot be read or decoded. */
    fun ofFile(source: Source, file: Path): Texture? {
        val textures = source.loading.textures
        val key = file.toRealPath()
        if (key !in textures) {
            val bytes = FileReferences.read(file)
            bytes?.let { source.loading.read(it.size) }
            textures[key] = bytes?.let { decode(source, it, file.fileName.toString()) }
        }
        return textures[key]
    }
}
