package dev.lazyz.scenes.writers.animation

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
