package dev.lazyz.scenes.aov

import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovImage
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.scenes.writers.PfmRows
import java.io.BufferedOutputStream
import java.io.IOException
import java.nio.channels.Channels
import java.nio.channels.FileChannel
import java.nio.file.Path

/**
 * Writes AOVs to files, as data. For pictures of them, see [AovPicture].
 *
 * ```
 * val aovs = AovFrame(frame, setOf(Aov.DEPTH, Aov.NORMAL)).render(Tiled())
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
