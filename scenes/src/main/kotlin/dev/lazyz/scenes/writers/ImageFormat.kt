package dev.lazyz.scenes.writers

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
