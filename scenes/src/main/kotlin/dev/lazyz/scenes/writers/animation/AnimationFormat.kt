package dev.lazyz.scenes.writers.animation

/**
 * The file formats that an animation can be written to.
 *
 * @property id lower-case name
 * @property extensions file name extensions, lower case, without a dot
 */
public enum class AnimationFormat(public val id: String, public val extensions: List<String>) {
    /** Animated PNG: all colours and alpha, lossless, see [ApngSink]. */
    APNG("apng", listOf("apng", "png")),

    /** GIF: 256 colours for all frames, pixels opaque or transparent, see [GifSink]. */
    GIF("gif", listOf("gif")),
    ;

    public companion object {
        /** Returns the format that a file name's extension belongs to, or null. */
        @JvmStatic
        public fun ofFileName(name: String): AnimationFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}
