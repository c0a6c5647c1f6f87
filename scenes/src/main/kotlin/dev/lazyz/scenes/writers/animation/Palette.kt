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

/**
 * Chooses colours for the pixels of a [histogram]: boxes of cells are split at the mean of their most varied channel,
 * the box with the greatest sum of squared deviations first. A colour is the mean of the pixels in a box.
 */
internal class MedianCut(private val histogram: ColorHistogram) {
    private val cells = histogram.filledCells()

    /** Returns at most [most] colours, `0xFFRRGGBB`. */
    fun colors(most: Int): List<Int> {
        val boxes = ArrayList<Box>()
        if (cells.isNotEmpty()) boxes.add(Box(0, cells.size))
        while (boxes.size < most) {
            val widest = boxes.filter { it.end - it.start > 1 }.maxByOrNull { it.deviation } ?: break
            boxes.remove(widest)
            boxes.addAll(widest.split())
        }
        return boxes.map { it.color }
    }

    /** The cells from number [start] to before [end]. */
    private inner class Box(val start: Int, val end: Int) {
        private val count = (start until end).sumOf { histogram.count(cells[it]) }
        private val means = DoubleArray(ColorHistogram.CHANNELS) { sum(it).toDouble() / count }
        private val deviations = DoubleArray(ColorHistogram.CHANNELS) { deviation(it) }

        /** The greatest sum of squared deviations of a channel. */
        val deviation: Double = deviations.max()

        /** The mean colour. */
        val color: Int
            get() = means.fold(0xFF) { color, mean -> color shl 8 or (mean + 0.5).toInt().coerceAtMost(255) }

        private fun sum(channel: Int): Long = (start until end).sumOf { histogram.sum(cells[it], channel) }

        /** Returns the sum of squared deviations of the means of cells from that of the box. */
        private fun deviation(channel: Int): Double {
            var total = 0.0
            for (i in start until end) {
                val d = mean(cells[i], channel) - means[channel]
                total += d * d * histogram.count(cells[i])
            }
            return total
        }

        private fun mean(cell: Int, channel: Int): Double =
            histogram.sum(cell, channel).toDouble() / histogram.count(cell)

        /** Sorts the cells by the most varied channel, and returns those up to the mean, and the others. */
        fun split(): List<Box> {
            val channel = deviations.indices.maxByOrNull { deviations[it] } ?: 0
            val sorted = cells.slice(start until end).sortedBy { mean(it, channel) }
            for ((i, cell) in sorted.withIndex()) cells[start + i] = cell
            val below = sorted.count { mean(it, channel) <= means[channel] }
            val middle = start + below.coerceIn(1, end - start - 1)
            return listOf(Box(start, middle), Box(middle, end))
        }
    }
}

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
