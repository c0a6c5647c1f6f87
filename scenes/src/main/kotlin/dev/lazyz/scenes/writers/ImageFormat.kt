package dev.lazyz.scenes.writers

/**
 * The kinds of file that a picture can be written to.
 *
 * @property id name on command lines, lower case
 * @property extensions endings of file names, lower case, without a dot
 */
public enum class ImageFormat(public val id: String, public val extensions: List<String>) {
    /** Portable Network Graphics: colours, compressed without loss, see [PngSink]. */
    PNG("png", listOf("png")),

    /** Portable pixmap: colours, not compressed, see [PpmSink]. */
    PPM("ppm", listOf("ppm")),

    /** Portable float map: depths, not compressed, see [PfmSink]. */
    PFM("pfm", listOf("pfm")),
    ;

    public companion object {
        /** Returns the format that a file name's ending stands for, or null. */
        @JvmStatic
        public fun ofFileName(name: String): ImageFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}
