package dev.lazyz

import dev.lazyz.spi.Srgb
import kotlin.math.abs
import kotlin.math.floor

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

    /** Returns red (0), green (1) or blue (2). */
    internal fun channel(channel: Int): Float = when (channel) {
        0 -> red
        1 -> green
        else -> blue
    }

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

        /**
         * Returns the colour at [position] of the scale Viridis, from dark blue, 0, over green to yellow, 1. Less, and
         * NaN, count as 0; more counts as 1. The scale is even in brightness, also for colour-blind readers and in grey
         * prints. For pictures of numbers, such as depth or overdraw.
         *
         * It is given by eight colours, evenly spaced, and is linear in the codes of sRGB between them; so it is within
         * a few codes of the scale that it is named after (Stéfan van der Walt and Nathaniel Smith, Matplotlib 2.0,
         * 2015).
         */
        @JvmStatic
        public fun viridis(position: Double): Rgba {
            val place = (if (position > 0.0) minOf(position, 1.0) else 0.0) * (VIRIDIS.size - 1)
            val lower = minOf(floor(place).toInt(), VIRIDIS.size - 2)
            var rgb = 0
            for (shift in 16 downTo 0 step 8) {
                val from = VIRIDIS[lower] shr shift and 0xFF
                val to = VIRIDIS[lower + 1] shr shift and 0xFF
                rgb = rgb or (floor(from + (place - lower) * (to - from) + 0.5).toInt() shl shift)
            }
            return ofRgb(rgb)
        }

        /** Eight colours of Viridis from dark to light, evenly spaced, `0xRRGGBB`. */
        private val VIRIDIS =
            intArrayOf(0x440154, 0x46327E, 0x365C8D, 0x277F8E, 0x1FA187, 0x4AC16D, 0xA0DA39, 0xFDE725)

        /** The hues at which the components are alone, in sixths of a turn. */
        private const val RED_SEXTANT = 0.0
        private const val GREEN_SEXTANT = 2.0
        private const val BLUE_SEXTANT = 4.0

        /** The possible numbers of hexadecimal digits. */
        private val DIGITS = setOf(3, 6, 8)

        private fun isHexadecimal(digit: Char): Boolean = digit in '0'..'9' || digit.lowercaseChar() in 'a'..'f'
    }
}

/** The names of colours in CSS ("CSS Color Module Level 4", sections 6.1 and 6.3). */
internal object CssColors {
    private const val TABLE = """
        aliceblue f0f8ff, antiquewhite faebd7, aqua 00ffff, aquamarine 7fffd4, azure f0ffff, beige f5f5dc,
        bisque ffe4c4, black 000000, blanchedalmond ffebcd, blue 0000ff, blueviolet 8a2be2, brown a52a2a,
        burlywood deb887, cadetblue 5f9ea0, chartreuse 7fff00, chocolate d2691e, coral ff7f50, cornflowerblue 6495ed,
        cornsilk fff8dc, crimson dc143c, cyan 00ffff, darkblue 00008b, darkcyan 008b8b, darkgoldenrod b8860b,
        darkgray a9a9a9, darkgreen 006400, darkgrey a9a9a9, darkkhaki bdb76b, darkmagenta 8b008b,
        darkolivegreen 556b2f, darkorange ff8c00, darkorchid 9932cc, darkred 8b0000, darksalmon e9967a,
        darkseagreen 8fbc8f, darkslateblue 483d8b, darkslategray 2f4f4f, darkslategrey 2f4f4f, darkturquoise 00ced1,
        darkviolet 9400d3, deeppink ff1493, deepskyblue 00bfff, dimgray 696969, dimgrey 696969, dodgerblue 1e90ff,
        firebrick b22222, floralwhite fffaf0, forestgreen 228b22, fuchsia ff00ff, gainsboro dcdcdc,
        ghostwhite f8f8ff, gold ffd700, goldenrod daa520, gray 808080, green 008000, greenyellow adff2f, grey 808080,
        honeydew f0fff0, hotpink ff69b4, indianred cd5c5c, indigo 4b0082, ivory fffff0, khaki f0e68c,
        lavender e6e6fa, lavenderblush fff0f5, lawngreen 7cfc00, lemonchiffon fffacd, lightblue add8e6,
        lightcoral f08080, lightcyan e0ffff, lightgoldenrodyellow fafad2, lightgray d3d3d3, lightgreen 90ee90,
        lightgrey d3d3d3, lightpink ffb6c1, lightsalmon ffa07a, lightseagreen 20b2aa, lightskyblue 87cefa,
        lightslategray 778899, lightslategrey 778899, lightsteelblue b0c4de, lightyellow ffffe0, lime 00ff00,
        limegreen 32cd32, linen faf0e6, magenta ff00ff, maroon 800000, mediumaquamarine 66cdaa, mediumblue 0000cd,
        mediumorchid ba55d3, mediumpurple 9370db, mediumseagreen 3cb371, mediumslateblue 7b68ee,
        mediumspringgreen 00fa9a, mediumturquoise 48d1cc, mediumvioletred c71585, midnightblue 191970,
        mintcream f5fffa, mistyrose ffe4e1, moccasin ffe4b5, navajowhite ffdead, navy 000080, oldlace fdf5e6,
        olive 808000, olivedrab 6b8e23, orange ffa500, orangered ff4500, orchid da70d6, palegoldenrod eee8aa,
        palegreen 98fb98, paleturquoise afeeee, palevioletred db7093, papayawhip ffefd5, peachpuff ffdab9,
        peru cd853f, pink ffc0cb, plum dda0dd, powderblue b0e0e6, purple 800080, rebeccapurple 663399, red ff0000,
        rosybrown bc8f8f, royalblue 4169e1, saddlebrown 8b4513, salmon fa8072, sandybrown f4a460, seagreen 2e8b57,
        seashell fff5ee, sienna a0522d, silver c0c0c0, skyblue 87ceeb, slateblue 6a5acd, slategray 708090,
        slategrey 708090, snow fffafa, springgreen 00ff7f, steelblue 4682b4, tan d2b48c, teal 008080, thistle d8bfd8,
        tomato ff6347, turquoise 40e0d0, violet ee82ee, wheat f5deb3, white ffffff, whitesmoke f5f5f5, yellow ffff00,
        yellowgreen 9acd32
    """

    /** The colours by name, in lower case. */
    val byName: Map<String, Rgba> = buildMap {
        put("transparent", Rgba.TRANSPARENT)
        for (entry in TABLE.split(',')) {
            val (name, rgb) = entry.trim().split(' ')
            put(name, Rgba.ofRgb(rgb.toInt(16)))
        }
    }
}
