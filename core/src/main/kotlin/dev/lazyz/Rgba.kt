package dev.lazyz

/**
 * A colour in linear light with straight (not premultiplied) alpha.
 *
 * Components are normally in 0..1. Larger values are allowed, and are clamped when the colour is packed (contract rule
 * 6.4). Immutable and thread safe.
 */
public class Rgba @JvmOverloads constructor(
    public val red: Float,
    public val green: Float,
    public val blue: Float,
    public val alpha: Float = 1f,
) {
    /** Packs this colour to 8-bit sRGB, `0xAARRGGBB`, each component rounded to the nearest code. */
    public fun toArgb(): Int = Srgb.pack(red, green, blue, alpha)

    /** Returns this colour with its alpha replaced. */
    public fun withAlpha(alpha: Float): Rgba = Rgba(red, green, blue, alpha)

    /** Returns this colour with red, green and blue multiplied by [factor]; alpha is unchanged. */
    public fun scaled(factor: Float): Rgba = Rgba(red * factor, green * factor, blue * factor, alpha)

    override fun equals(other: Any?): Boolean =
        other is Rgba && red == other.red && green == other.green && blue == other.blue && alpha == other.alpha

    override fun hashCode(): Int =
        ((red.hashCode() * 31 + green.hashCode()) * 31 + blue.hashCode()) * 31 + alpha.hashCode()

    override fun toString(): String = "Rgba($red, $green, $blue, $alpha)"

    public companion object {
        /** Opaque white. */
        @JvmField
        public val WHITE: Rgba = Rgba(1f, 1f, 1f)

        /** Opaque black. */
        @JvmField
        public val BLACK: Rgba = Rgba(0f, 0f, 0f)

        /** Fully transparent: black with alpha 0. */
        @JvmField
        public val TRANSPARENT: Rgba = Rgba(0f, 0f, 0f, 0f)

        /** Unpacks an 8-bit sRGB colour, `0xAARRGGBB`. */
        @JvmStatic
        public fun ofArgb(argb: Int): Rgba = Rgba(
            Srgb.decode(argb ushr 16 and 0xFF),
            Srgb.decode(argb ushr 8 and 0xFF),
            Srgb.decode(argb and 0xFF),
            (argb ushr 24) / 255f,
        )

        /** Unpacks an opaque 8-bit sRGB colour, `0xRRGGBB`; the upper byte is ignored. */
        @JvmStatic
        public fun ofRgb(rgb: Int): Rgba = ofArgb(rgb or (0xFF shl 24))

        /**
         * Parses an sRGB colour: `#rgb`, `#rrggbb`, `#rrggbbaa`, `transparent`, `black` or `white`.
         *
         * @throws IllegalArgumentException if [text] has none of these forms
         */
        @JvmStatic
        public fun parse(text: String): Rgba {
            when (text) {
                "transparent" -> return TRANSPARENT
                "black" -> return BLACK
                "white" -> return WHITE
            }
            require(text.matches(HEX)) {
                "colour must be #rgb, #rrggbb, #rrggbbaa, transparent, black or white: $text"
            }
            val digits = text.substring(1)
            val long = if (digits.length == 3) digits.map { "$it$it" }.joinToString("") else digits
            val rgb = long.substring(0, 6).toInt(16)
            val alpha = if (long.length == 8) long.substring(6).toInt(16) else 0xFF
            return ofArgb(alpha shl 24 or rgb)
        }

        private val HEX = Regex("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})")
    }
}
