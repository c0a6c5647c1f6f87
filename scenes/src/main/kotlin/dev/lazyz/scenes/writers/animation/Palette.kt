package dev.lazyz.scenes.writers.animation

/**
 * At most 256 colours, and the number of the nearest one for each colour.
 *
 * @property colors `0xFFRRGGBB`
 * @property transparent the number of the transparent entry, which follows the colours, or -1
 */
internal class Palette private constructor(val colors: IntArray, hasTransparency: Boolean) {
    val transparent: Int = if (hasTransparency) colors.size else -1

    /** Number of entries, with the transparent one. */
    val size: Int get() = colors.size + if (transparent >= 0) 1 else 0

    private val numbers = colors.withIndex().associate { (number, color) -> color to number }

    /** One more than the number of the nearest colour of each cell of [ColorHistogram]; 0 if it was not searched. */
    private val nearest = ShortArray(ColorHistogram.CELLS)

    /** Returns the numbers of the pixels of a frame. */
    fun numbersOf(argb: IntArray): ByteArray {
        val result = ByteArray(argb.size)
        var last = 0
        var number = -1
        for (i in argb.indices) {
            val color = argb[i]
            if (number < 0 || color != last) number = numberOf(color)
            last = color
            result[i] = number.toByte()
        }
        return result
    }

    private fun numberOf(color: Int): Int {
        if (transparent >= 0 && ColorHistogram.isTransparent(color)) return transparent
        val opaque = color or (0xFF shl 24)
        numbers[opaque]?.let { return it }
        val cell = ColorHistogram.cell(opaque)
        if (nearest[cell] == 0.toShort()) nearest[cell] = (1 + search(opaque or CELL_MIDDLE)).toShort()
        return nearest[cell] - 1
    }

    private fun search(color: Int): Int {
        var best = 0
        var least = Int.MAX_VALUE
        for (number in colors.indices) {
            var distance = 0
            for (channel in 0 until ColorHistogram.CHANNELS) {
                val d = ColorHistogram.channel(color, channel) - ColorHistogram.channel(colors[number], channel)
                distance += d * d
            }
            if (distance < least) {
                least = distance
                best = number
            }
        }
        return best
    }

    companion object {
        private const val MOST = 256

        /** Sets the lower two bits of each channel to the same value for all colours of a cell: 2. */
        private const val CELL_MIDDLE = 0x020202

        /** Chooses the palette for the pixels of [histogram]; [kept] is one of its colours, and stays exact. */
        fun of(histogram: ColorHistogram, kept: Int): Palette {
            val most = if (histogram.hasTransparency) MOST - 1 else MOST
            val exact = histogram.exactColors
            if (exact != null && exact.size <= most) return Palette(exact, histogram.hasTransparency)
            val isKept = !(histogram.hasTransparency && ColorHistogram.isTransparent(kept))
            val exactly = if (isKept) listOf(kept or (0xFF shl 24)) else emptyList()
            val chosen = exactly + MedianCut(histogram).colors(most - exactly.size)
            return Palette(chosen.distinct().toIntArray(), histogram.hasTransparency)
        }
    }
}
