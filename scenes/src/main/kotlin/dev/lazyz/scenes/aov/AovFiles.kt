package dev.lazyz.scenes.aov

import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.scenes.writers.PfmRows
import dev.lazyz.scenes.writers.PngChunks
import java.io.BufferedOutputStream
import java.io.IOException
import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.Channels
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.time.LocalDateTime
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/**
 * Writes AOVs to files, as data. For pictures of them, see [AovPicture].
 *
 * ```
 * val aovs = AovFrame(frame, setOf(Aov.DEPTH, Aov.NORMAL)).render(TiledRenderer())
 * AovFiles.write(Path.of("depth.pfm"), aovs[Aov.DEPTH])
 * AovFiles.write(Path.of("all.npz"), aovs.images)
 * ```
 *
 * A file appears only when it is complete: until then an old file with the same name stays, and a failure leaves no
 * partial file. The same AOVs give the same bytes. Memory: that of a row, or of its compressed form.
 */
public object AovFiles {
    /**
     * Writes one AOV.
     *
     * @param format the file format; by default determined by the file name extension
     * @throws IllegalArgumentException if [format] is omitted and the extension is unknown, or if the AOV, or one of
     *   its numbers, does not fit into the format; the message says what to do
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(path: Path, image: AovImage, format: AovFormat = formatOf(path)): Unit =
        write(path, listOf(image), format)

    /**
     * Writes several AOVs to one file. Only [AovFormat.NPZ] has room for more or less than one. Otherwise like the
     * other [write].
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(path: Path, images: List<AovImage>, format: AovFormat = formatOf(path)) {
        require(format == AovFormat.NPZ || images.size == 1) {
            "cannot write $path: a .${format.id} file has one AOV, and these are ${images.size}; use .npz"
        }
        for (image in images) {
            val obstacle = format.obstacle(image.aov) ?: if (format == AovFormat.PNG) DeepPng.obstacle(image) else null
            require(obstacle == null) { "cannot write $path: $obstacle" }
        }
        AtomicFile.write(path) { channel ->
            when (format) {
                AovFormat.PFM -> writePfm(channel, images.single())
                AovFormat.NPY -> buffered(channel).use { Npy.write(it, images.single()) }
                AovFormat.NPZ -> Npy.writeArchive(buffered(channel), images)
                AovFormat.JSON -> buffered(channel).writer().use { ObjectTable.write(it, images.single()) }
                AovFormat.PNG -> buffered(channel).use { DeepPng.write(it, images.single()) }
            }
        }
    }

    /**
     * Writes several AOVs as [AovFormat.NPZ] to [output], and closes it.
     *
     * @throws IOException if writing to the stream fails
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun writeArchive(output: OutputStream, images: List<AovImage>): Unit = Npy.writeArchive(output, images)

    private fun formatOf(path: Path): AovFormat = requireNotNull(AovFormat.ofPath(path)) {
        "cannot tell the format of $path: it must end in one of ${AovFormat.entries.joinToString { ".${it.id}" }}"
    }

    private fun buffered(channel: FileChannel) = BufferedOutputStream(Channels.newOutputStream(channel), BUFFER)

    private fun writePfm(channel: FileChannel, image: AovImage) {
        val own = image.aov.channels.size
        val all = if (own == 1) 1 else 3
        val rows = PfmRows(channel, image.width, image.height, all)
        for (y in 0 until image.height) {
            rows.write(y) { i ->
                if (i % all < own) image.numberAt(y * image.width + i / all, i % all).toFloat() else 0f
            }
        }
    }

    private const val BUFFER = 1 shl 16
}

/**
 * The file formats of AOVs as data.
 *
 * @property id lower-case name, and file name extension
 */
public enum class AovFormat(public val id: String) {
    /**
     * Portable float map, one AOV: 32-bit numbers, one channel (`Pf`) or three (`PF`; the third number of texture
     * coordinates is 0). The format has the bottom row first. Integers above 2^24 are rounded.
     */
    PFM("pfm"),

    /** NumPy array, one AOV: `<f4` or `<i4`, with the shape (rows, columns) or (rows, columns, channels). */
    NPY("npy"),

    /**
     * Archive of NumPy arrays, any number of AOVs: an array for each, with its id as name, and for [Aov.OBJECT] also
     * `object-names`, the names of all objects of the scene by their number. Compressed.
     */
    NPZ("npz"),

    /**
     * PNG with 16 bits a channel, one AOV; one channel (grey) or three (RGB; the third number of texture coordinates is
     * 0). Depth is linear: 0 at the near plane, 65534 at the far plane, which the text chunks `near` and `far` give in
     * units of the scene, and 65535 where nothing is visible. Ids are increased by 1, so that 0 is the background;
     * counts are as they are. Normals are -1..1, coverage and texture coordinates 0..1, for 0..65535. Positions cannot
     * be written.
     */
    PNG("png"),

    /** The objects of [Aov.OBJECT], one AOV: a table of their names and visible pixels, see [ObjectTable]. JSON. */
    JSON("json"),
    ;

    /** Returns why [aov] cannot be written in this format, or null if it can. */
    public fun obstacle(aov: Aov): String? = when {
        this == PNG && aov == Aov.POSITION -> "positions have no range that 16 bits could show; use .npy or .pfm"
        this == JSON && aov != Aov.OBJECT -> "a .json file lists objects; use .npz for '${aov.id}'"
        else -> null
    }

    public companion object {
        /** Returns the format for the file name extension of [path], or null. */
        @JvmStatic
        public fun ofPath(path: Path): AovFormat? {
            val extension = path.fileName?.toString().orEmpty().substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { it.id == extension }
        }
    }
}

/** PNG files with 16 bits a channel, see [AovFormat.PNG]. */
internal object DeepPng {
    private const val MOST = 65535

    /** Filter 1 of the specification: differences to the pixel on the left. */
    private const val SUB = 1

    /** Returns why the numbers of [image] do not fit, or null if they do. */
    fun obstacle(image: AovImage): String? {
        if (!image.aov.isInteger) return null
        val most = image.ints.max()
        if (most.toLong() - image.aov.background.toLong() <= MOST) return null
        return "'${image.aov.id}' reaches $most, which 16 bits cannot hold; use .npy"
    }

    /** Writes [image] to [output], without closing it. */
    fun write(output: OutputStream, image: AovImage) {
        val own = image.aov.channels.size
        val all = if (own == 1) 1 else 3
        val chunks = PngChunks(output)
        chunks.header(image.width, image.height, depth = 16, if (all == 1) PngChunks.GREY else PngChunks.RGB)
        text(chunks, "aov", image.aov.id)
        if (image.aov == Aov.DEPTH) {
            text(chunks, "near", "${image.lowest}")
            text(chunks, "far", "${image.highest}")
        }

        // Each buffer of compressed bytes is a chunk
        val data = object : OutputStream() {
            override fun write(byte: Int) = write(byteArrayOf(byte.toByte()), 0, 1)

            override fun write(bytes: ByteArray, offset: Int, length: Int) =
                chunks.write(PngChunks.DATA, bytes.copyOfRange(offset, offset + length))
        }
        val deflater = Deflater()
        try {
            val chunked = BufferedOutputStream(data, PngChunks.DATA_SIZE)
            DeflaterOutputStream(chunked, deflater, PngChunks.DATA_SIZE).use { pixels ->
                for (y in 0 until image.height) pixels.write(row(image, y, own, all))
            }
        } finally {
            deflater.end()
        }
        chunks.write(PngChunks.END, ByteArray(0))
    }

    private fun text(chunks: PngChunks, keyword: String, value: String) =
        chunks.write("tEXt", "$keyword\u0000$value".toByteArray(Charsets.ISO_8859_1))

    /** Returns row [y]: the filter, then differences of [all] channels for each pixel, of which [own] are not 0. */
    private fun row(image: AovImage, y: Int, own: Int, all: Int): ByteArray {
        val bytes = ByteArray(1 + 2 * all * image.width)
        bytes[0] = SUB.toByte()
        val left = IntArray(all)
        for (i in 0 until all * image.width) {
            val channel = i % all
            val code = if (channel < own) code(image, image.numberAt(y * image.width + i / all, channel)) else 0
            bytes[1 + 2 * i] = ((code ushr 8) - (left[channel] ushr 8)).toByte()
            bytes[2 + 2 * i] = (code - left[channel]).toByte()
            left[channel] = code
        }
        return bytes
    }

    /** Returns the code of [number], 0..[MOST]. NaN is 0. */
    private fun code(image: AovImage, number: Double): Int {
        if (image.aov.isInteger) return (number - image.aov.background).toInt()
        if (image.aov == Aov.DEPTH && number == image.aov.background) return MOST
        val most = if (image.aov == Aov.DEPTH) MOST - 1 else MOST
        val place = (number - image.lowest) / (image.highest - image.lowest)
        return if (place > 0.0) Math.rint(minOf(place, 1.0) * most).toInt() else 0
    }
}

/**
 * NumPy's files of arrays, version 1.0, and archives of them.
 *
 * Source: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays".
 */
internal object Npy {
    /** The length of the header, with all before it, is a multiple of this. */
    private const val ALIGNMENT = 64
    private val MAGIC = byteArrayOf(0x93.toByte()) + "NUMPY".toByteArray(Charsets.US_ASCII) + byteArrayOf(1, 0)

    /** Halves of pairs, which are no characters alone, and what is written for them. */
    private val SURROGATES = 0xD800..0xDFFF
    private const val REPLACEMENT = 0xFFFD

    /** The least time that archives can store, so that the same arrays give the same bytes. */
    private val TIME = LocalDateTime.of(1980, 1, 1, 0, 0)

    /** Writes [image] as an array to [output]. */
    fun write(output: OutputStream, image: AovImage) {
        output.write(header(image))
        val channels = image.aov.channels.size
        val bytes = ByteBuffer.allocate(Int.SIZE_BYTES * image.width * channels).order(ByteOrder.LITTLE_ENDIAN)
        val numbers = image.width * channels
        for (y in 0 until image.height) {
            bytes.clear()
            if (image.aov.isInteger) {
                bytes.asIntBuffer().put(image.ints, y * numbers, numbers)
            } else {
                bytes.asFloatBuffer().put(image.floats, y * numbers, numbers)
            }
            output.write(bytes.array())
        }
    }

    /** Writes [images] as an archive to [output], and closes it. */
    fun writeArchive(output: OutputStream, images: List<AovImage>) {
        ZipOutputStream(output).use { archive ->
            for (image in images) {
                archive.putNextEntry(ZipEntry("${image.aov.id}.npy").apply { timeLocal = TIME })
                write(archive, image)
                archive.closeEntry()
                if (image.names.isEmpty()) continue
                archive.putNextEntry(ZipEntry("${image.aov.id}-names.npy").apply { timeLocal = TIME })
                write(archive, image.names)
                archive.closeEntry()
            }
        }
    }

    /** Writes [texts] as an array: code points, with zeros up to the length of the longest. */
    private fun write(output: OutputStream, texts: List<String>) {
        val longest = maxOf(texts.maxOf { it.codePointCount(0, it.length) }, 1)
        output.write(header("<U$longest", "${texts.size},"))
        val bytes = ByteBuffer.allocate(Int.SIZE_BYTES * longest).order(ByteOrder.LITTLE_ENDIAN)
        for (text in texts) {
            bytes.array().fill(0)
            bytes.clear()
            for (point in text.codePoints()) bytes.putInt(if (point in SURROGATES) REPLACEMENT else point)
            output.write(bytes.array())
        }
    }

    private fun header(image: AovImage): ByteArray {
        val channels = image.aov.channels.size
        val shape = listOf(image.height, image.width) + if (channels == 1) emptyList() else listOf(channels)
        return header(if (image.aov.isInteger) "<i4" else "<f4", shape.joinToString())
    }

    private fun header(type: String, shape: String): ByteArray {
        val text = "{'descr': '$type', 'fortran_order': False, 'shape': ($shape), }"
        val before = MAGIC.size + Short.SIZE_BYTES
        val length = (before + text.length + ALIGNMENT) / ALIGNMENT * ALIGNMENT - before
        val padded = text.padEnd(length - 1) + "\n"
        val size = byteArrayOf(length.toByte(), (length ushr 8).toByte())
        return MAGIC + size + padded.toByteArray(Charsets.US_ASCII)
    }
}
