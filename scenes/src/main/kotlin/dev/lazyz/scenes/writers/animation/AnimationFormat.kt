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

    /** Returns why a file of this format cannot have frames of [width] x [height] pixels, or null if it can. */
    public fun obstacle(width: Int, height: Int): String? = when {
        this != GIF -> null
        maxOf(width, height) > MAX_GIF_SIDE -> "a GIF has at most $MAX_GIF_SIDE columns and rows: ${width}x$height"
        width.toLong() * height > MAX_GIF_PIXELS -> "a GIF frame has at most $MAX_GIF_PIXELS pixels: ${width}x$height"
        else -> null
    }

    public companion object {
        private const val MAX_GIF_SIDE = 0xFFFF

        /** A frame is in an array. */
        private const val MAX_GIF_PIXELS = Int.MAX_VALUE - 8L

        /** Returns the format that a file name's extension belongs to, or null. */
        @JvmStatic
        public fun ofFileName(name: String): AnimationFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}
