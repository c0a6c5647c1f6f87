package dev.lazyz

import kotlin.math.floor

/**
 * Viridis, a scale of colours from dark blue over green to yellow. It is even in brightness, also for colour-blind
 * readers and in grey prints. For pictures of numbers, such as depth or overdraw.
 *
 * It is given by eight colours, evenly spaced, and is linear in the codes of sRGB between them; so it is within a few
 * codes of the scale that it is named after (Stéfan van der Walt and Nathaniel Smith, Matplotlib 2.0, 2015).
 */
public object Viridis {
    /** Eight colours from dark to light, evenly spaced, `0xRRGGBB`. */
    private val colors = intArrayOf(0x440154, 0x46327E, 0x365C8D, 0x277F8E, 0x1FA187, 0x4AC16D, 0xA0DA39, 0xFDE725)

    /** Returns the colour number [step], 0..7, of those that define the scale. */
    internal fun step(step: Int): Rgba = Rgba.ofRgb(colors[step])

    /**
     * Returns the colour at [position], `0xFFRRGGBB`: 0 is the dark end, 1 the light one. Less, and NaN, count as 0;
     * more counts as 1.
     */
    @JvmStatic
    public fun argb(position: Double): Int {
        val place = (if (position > 0.0) minOf(position, 1.0) else 0.0) * (colors.size - 1)
        val lower = minOf(floor(place).toInt(), colors.size - 2)
        var argb = 0xFF shl 24
        for (shift in listOf(16, 8, 0)) {
            val from = colors[lower] shr shift and 0xFF
            val to = colors[lower + 1] shr shift and 0xFF
            argb = argb or (floor(from + (place - lower) * (to - from) + 0.5).toInt() shl shift)
        }
        return argb
    }
}
