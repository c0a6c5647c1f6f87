package dev.lazyz

import kotlin.math.abs

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

    /** Components are compared as [Float.compareTo] does: NaN equals NaN, and -0 is less than 0. */
    override fun equals(other: Any?): Boolean = other is Rgba && red.compareTo(other.red) == 0 &&
        green.compareTo(other.green) == 0 && blue.compareTo(other.blue) == 0 && alpha.compareTo(other.alpha) == 0

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
         * Returns the linear light, 0..1, of an sRGB-encoded component, as files store it (IEC 61966-2-1). Values
         * outside 0..1 are clamped, and NaN gives 0. The bits are the same on every machine.
         */
        @JvmStatic
        public fun linearOf(encoded: Double): Float = when {
            !(encoded > 0.0) -> 0f
            encoded >= 1.0 -> 1f
            else -> Srgb.decode(encoded).toFloat()
        }

        /**
         * Returns the colour of a hue, a saturation and a value (HSV, also called HSB).
         *
         * As in image editors, HSV describes the sRGB-encoded components, each in 0..1; they are then decoded to the
         * linear light of this class. So `hsv(h, s, v).toArgb()` is the 8-bit colour that an editor shows for h, s and
         * v. With saturation 0 the colour is grey, whatever the hue; with value 0 it is black.
         *
         * Source: Alvy Ray Smith, "Color Gamut Transform Pairs", SIGGRAPH 1978, the hexcone model. There a hue is a
         * fraction of the full turn, here it is in degrees.
         *
         * @param hueDegrees angle in degrees, any finite number: 0 is red, 60 yellow, 120 green, 180 cyan, 240 blue,
         *   300 magenta, and 360 red again
         * @param saturation distance from grey, 0..1
         * @param value the largest of the three encoded components, 0..1
         * @param alpha opacity, 0..1
         * @throws IllegalArgumentException if a number is outside its range or NaN
         */
        @JvmStatic
        @JvmOverloads
        public fun hsv(hueDegrees: Float, saturation: Float, value: Float, alpha: Float = 1f): Rgba {
            require(hueDegrees.isFinite()) { "hueDegrees must be finite: $hueDegrees" }
            require(saturation in 0f..1f) { "saturation must be in 0..1: $saturation" }
            require(value in 0f..1f) { "value must be in 0..1: $value" }
            require(alpha in 0f..1f) { "alpha must be in 0..1: $alpha" }
            val sextant = hueDegrees.toDouble().mod(360.0) / 60.0
            return Rgba(
                ofHexcone(sextant, RED_SEXTANT, saturation, value),
                ofHexcone(sextant, GREEN_SEXTANT, saturation, value),
                ofHexcone(sextant, BLUE_SEXTANT, saturation, value),
                alpha,
            )
        }

        /**
         * Returns a component in linear light. Its encoded value is largest up to one sextant away from its own hue,
         * [own], and least from two sextants on; it is linear in between.
         */
        private fun ofHexcone(sextant: Double, own: Double, saturation: Float, value: Float): Float {
            val difference = abs(sextant - own)
            val distance = minOf(difference, 6.0 - difference)
            val missing = (distance - 1.0).coerceIn(0.0, 1.0)
            return Srgb.decode(value * (1.0 - saturation * missing)).toFloat()
        }

        /**
         * The names of colours that [parse] knows, in lower case: those of CSS, and `transparent` (CSS Color Module
         * Level 4).
         */
        @JvmStatic
        public val names: Set<String> get() = CssColors.byName.keys

        /**
         * Parses an sRGB colour: `#rgb`, `#rrggbb`, `#rrggbbaa`, or one of [names] in upper or lower case.
         *
         * @throws IllegalArgumentException if [text] has none of these forms
         */
        @JvmStatic
        public fun parse(text: String): Rgba {
            if (!text.startsWith("#")) CssColors.byName[text.lowercase()]?.let { return it }
            require(text.startsWith("#") && text.length - 1 in DIGITS && text.drop(1).all(::isHexadecimal)) {
                "colour must be #rgb, #rrggbb, #rrggbbaa, or a name of CSS, such as skyblue or transparent: $text"
            }
            val digits = text.substring(1)
            val long = if (digits.length == 3) digits.map { "$it$it" }.joinToString("") else digits
            val rgb = long.substring(0, 6).toInt(16)
            val alpha = if (long.length == 8) long.substring(6).toInt(16) else 0xFF
            return ofArgb(alpha shl 24 or rgb)
        }

        /** The hues at which the components are alone, in sixths of a turn. */
        private const val RED_SEXTANT = 0.0
        private const val GREEN_SEXTANT = 2.0
        private const val BLUE_SEXTANT = 4.0

        /** The possible numbers of hexadecimal digits. */
        private val DIGITS = setOf(3, 6, 8)

        private fun isHexadecimal(digit: Char): Boolean = digit in '0'..'9' || digit.lowercaseChar() in 'a'..'f'
    }
}
