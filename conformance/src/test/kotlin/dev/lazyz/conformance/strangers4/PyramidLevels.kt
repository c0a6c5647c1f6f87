package dev.lazyz.conformance.strangers4

import dev.lazyz.Frame
import dev.lazyz.Region

/**
 * The farthest key of each block of samples, of each 2 x 2 blocks, and so on up to one node. Bounds only: a node may
 * say more than is true, never less.
 *
 * @param side samples along a block's side
 */
internal class PyramidLevels(private val frame: Frame, val side: Int, private val mistake: Mistake?) {
    private val columns = ArrayList<Int>()
    private val nodes = ArrayList<LongArray>()

    init {
        var width = (frame.width + side - 1) / side
        var height = (frame.height + side - 1) / side
        while (true) {
            columns += width
            nodes += LongArray(width * height) { Long.MAX_VALUE }
            if (width == 1 && height == 1) break
            width = (width + 1) / 2
            height = (height + 1) / 2
        }
    }

    /** Returns the key that nothing shown in a block is behind. */
    fun block(column: Int, row: Int): Long = nodes[0][row * columns[0] + column]

    /** Returns a key that nothing shown in [area] is behind. */
    fun farthest(area: Region): Long {
        var left = (area.columnStart - frame.region.columnStart) / side
        var right = (area.columnEnd - 1 - frame.region.columnStart) / side
        var top = (area.rowStart - frame.region.rowStart) / side
        var bottom = (area.rowEnd - 1 - frame.region.rowStart) / side
        var level = 0
        while (right - left > 1 || bottom - top > 1) {
            level++
            left /= 2
            right /= 2
            top /= 2
            bottom /= 2
        }
        if (mistake == Mistake.PYRAMID_ONE_NODE) return nodes[level][top * columns[level] + left]
        var most = Long.MIN_VALUE
        for (row in top..bottom) {
            for (column in left..right) most = maxOf(most, nodes[level][row * columns[level] + column])
        }
        return most
    }

    fun setBlock(column: Int, row: Int, farthest: Long) {
        var key = farthest
        if (mistake == Mistake.PYRAMID_FLOAT) key = (farthest ushr 32).toFloat().toInt().toLong() shl 32
        nodes[0][row * columns[0] + column] = key
    }

    /** Brings the nodes above the blocks of [area] up to date. */
    fun update(area: Region) {
        var left = (area.columnStart - frame.region.columnStart) / side
        var right = (area.columnEnd - 1 - frame.region.columnStart) / side
        var top = (area.rowStart - frame.region.rowStart) / side
        var bottom = (area.rowEnd - 1 - frame.region.rowStart) / side
        for (level in 1 until nodes.size) {
            left /= 2
            right /= 2
            top /= 2
            bottom /= 2
            for (row in top..bottom) for (column in left..right) updateNode(level, column, row)
        }
    }

    private fun updateNode(level: Int, column: Int, row: Int) {
        val below = nodes[level - 1]
        val width = columns[level - 1]
        val height = below.size / width
        var most = below[2 * row * width + 2 * column]
        if (mistake == Mistake.PYRAMID_ODD_EDGE && (2 * column + 1 == width || 2 * row + 1 == height)) {
            nodes[level][row * columns[level] + column] = most
            return
        }
        if (2 * column + 1 < width) most = maxOf(most, below[2 * row * width + 2 * column + 1])
        if (2 * row + 1 < height) {
            most = maxOf(most, below[(2 * row + 1) * width + 2 * column])
            if (2 * column + 1 < width) most = maxOf(most, below[(2 * row + 1) * width + 2 * column + 1])
        }
        nodes[level][row * columns[level] + column] = most
    }

    companion object {
        /** Bytes of the levels of a picture, headers included. */
        fun bytes(width: Int, height: Int, side: Int, mistake: Mistake?): Long {
            var columns = (width + side - 1) / side
            var rows = (height + side - 1) / side
            var bytes = 0L
            while (true) {
                bytes += 32 + 8L * columns * rows
                if ((columns == 1 && rows == 1) || mistake == Mistake.PYRAMID_BUDGET_OF_BASE) return bytes
                columns = (columns + 1) / 2
                rows = (rows + 1) / 2
            }
        }
    }
}
