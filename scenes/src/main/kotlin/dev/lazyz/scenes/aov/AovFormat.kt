package dev.lazyz.scenes.aov

import dev.lazyz.aov.Aov
import java.nio.file.Path

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
