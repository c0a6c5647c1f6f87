package dev.lazyz.scenes.writers.animation

/**
 * Counts the colours of frames: exactly while there are at most [MOST_EXACT], and in cells of 64 x 64 x 64 always.
 *
 * A cell keeps the number of its pixels and the sums of their channels.
 */
internal class ColorHistogram {
    private val counts = LongArray(CELLS)
    private val sums = Array(CHANNELS) { LongArray(CELLS) }
    private val exact = HashSet<Int>()

    /** Whether a pixel is transparent. */
    var hasTransparency: Boolean = false
        private set

    /** The distinct colours, `0xFFRRGGBB`, in ascending order; null if there are more than [MOST_EXACT]. */
    val exactColors: IntArray? get() = if (exact.size > MOST_EXACT) null else exact.toIntArray().apply { sort() }

    /** Adds the pixels of a frame; with [hasAlpha], those with an alpha below one half are only noted. */
    fun add(argb: IntArray, hasAlpha: Boolean) {
        var last = 0
        for (color in argb) {
            if (hasAlpha && isTransparent(color)) {
                hasTransparency = true
                continue
            }
            val opaque = color or OPAQUE
            val cell = cell(opaque)
            counts[cell]++
            for (channel in 0 until CHANNELS) sums[channel][cell] += channel(opaque, channel).toLong()
            if (opaque != last && exact.size <= MOST_EXACT) exact.add(opaque)
            last = opaque
        }
    }

    /** Returns the cells that have pixels, in ascending order. */
    fun filledCells(): IntArray = (0 until CELLS).filter { counts[it] > 0 }.toIntArray()

    fun count(cell: Int): Long = counts[cell]

    fun sum(cell: Int, channel: Int): Long = sums[channel][cell]

    companion object {
        const val MOST_EXACT: Int = 256
        const val CHANNELS: Int = 3
        const val CELLS: Int = 1 shl 18
        private const val OPAQUE = 0xFF shl 24

        /** Returns the cell of a colour: the upper six bits of red, green and blue. */
        fun cell(color: Int): Int =
            (color ushr 18 and 63 shl 12) or (color ushr 10 and 63 shl 6) or (color ushr 2 and 63)

        /** Returns red, green or blue of a colour, 0..255. */
        fun channel(color: Int, channel: Int): Int = color ushr (16 - 8 * channel) and 0xFF

        /** Whether alpha is below one half. */
        fun isTransparent(color: Int): Boolean = color ushr 24 < 128
    }
}
