package dev.lazyz.strategies.hierarchical

import dev.lazyz.Region

/**
 * The visibility keys of a region's samples, and over them a pyramid of the farthest key of each block.
 *
 * A block is a square of [BLOCK] x [BLOCK] samples; a cell of a level is four of the level below, and the top is one
 * cell. Whatever is behind a cell's key is hidden everywhere in the cell.
 *
 * Keys only become less, and so do the cells'. So a cell that is out of date still holds an upper bound, and whatever
 * is behind that is hidden as well: a cell is brought up to date only if its old key does not decide. A block counts
 * the samples that hold its farthest key; when the last of them is replaced, the block is out of date, and above it
 * those cells whose key was the same.
 *
 * Source: Ned Greene, Michael Kass, Gavin Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993, on the image-space
 * Z pyramid. There it stands on the samples, and a change runs up through it at once.
 *
 * @property region the samples
 * @param background the key of all samples to begin with
 */
internal class DepthPyramid(val region: Region, background: Long) {
    /** The least key so far of each sample, in rows from the region's top. Replace one and tell [replaced]. */
    val keys: LongArray

    /** Cells in rows from the top, blocks first. The complement of a key, which is negative, is out of date. */
    private val levels: Array<LongArray>

    /** Cells a row of each level. */
    private val widths: IntArray

    /** For each block the number of samples that hold its farthest key, while it is up to date. */
    private val holders: ByteArray

    /** Number of times that a cell was asked so far. */
    var looks: Long = 0
        private set

    /** Number of levels, the blocks' included. */
    val levelCount: Int get() = levels.size

    /** Bytes held. */
    val bytes: Long get() = Long.SIZE_BYTES * (keys.size + levels.sumOf { it.size.toLong() }) + holders.size

    init {
        require(region.size <= MAX_SAMPLES) { "the depth pyramid stands on at most $MAX_SAMPLES samples: $region" }
        keys = LongArray(region.size.toInt())
        keys.fill(background)

        // Halve both sides until one cell is left
        val all = ArrayList<LongArray>()
        val allWidths = ArrayList<Int>()
        var width = (region.width + BLOCK - 1) / BLOCK
        var height = (region.height + BLOCK - 1) / BLOCK
        holders = ByteArray(width * height) { index ->
            val columns = minOf(BLOCK, region.width - index % width * BLOCK)
            val rows = minOf(BLOCK, region.height - index / width * BLOCK)
            (columns * rows).toByte()
        }
        while (true) {
            all += LongArray(width * height) { background }
            allWidths += width
            if (width == 1 && height == 1) break
            width = (width + 1) / 2
            height = (height + 1) / 2
        }
        levels = all.toTypedArray()
        widths = allWidths.toIntArray()
    }

    /** Whether a fragment of the key [nearest] or behind it is hidden at every sample of the blocks in a rectangle. */
    fun isHidden(nearest: Long, firstColumn: Int, firstRow: Int, lastColumn: Int, lastRow: Int): Boolean {
        // Go up until the rectangle is at most two cells wide and high
        var level = 0
        while ((lastColumn shr level) - (firstColumn shr level) > 1 || (lastRow shr level) - (firstRow shr level) > 1) {
            level++
        }
        val columns = (firstColumn shr level)..(lastColumn shr level)
        for (row in (firstRow shr level)..(lastRow shr level)) {
            for (column in columns) {
                if (!isHidden(nearest, level, column, row)) return false
            }
        }
        return true
    }

    /** Whether a fragment of the key [nearest] or behind it is hidden at every sample of a cell. */
    fun isHidden(nearest: Long, level: Int, column: Int, row: Int): Boolean {
        looks++
        val cell = levels[level][row * widths[level] + column]
        return nearest > upperBound(cell) || (cell < 0 && nearest > farthest(level, column, row))
    }

    /** Returns the farthest key of a block, or a key behind it: whatever is known without looking. */
    fun upperBound(column: Int, row: Int): Long = upperBound(levels[0][row * widths[0] + column])

    /** Whether the key of the block is the farthest of its samples. */
    fun isCurrent(column: Int, row: Int): Boolean = levels[0][row * widths[0] + column] >= 0

    /** Takes note that in a block that [isCurrent] [count] samples held its farthest key and hold lesser ones now. */
    fun replaced(column: Int, row: Int, count: Int) {
        val block = row * widths[0] + column
        val left = holders[block] - count
        holders[block] = left.toByte()
        if (left > 0) return

        // Nobody holds it any more; the cells above that have it from here are out of date, too
        val farthest = levels[0][block]
        for (level in levels.indices) {
            val at = (row shr level) * widths[level] + (column shr level)
            if (levels[level][at] != farthest) return
            levels[level][at] = farthest.inv()
        }
    }

    /** Returns the farthest key of a cell, after bringing it up to date. */
    private fun farthest(level: Int, column: Int, row: Int): Long {
        val at = row * widths[level] + column
        val known = levels[level][at]
        if (known >= 0) return known
        val farthest = if (level == 0) farthestOfSamples(column, row) else farthestOfCells(level - 1, column, row)
        levels[level][at] = farthest
        return farthest
    }

    /** The farthest key of the four cells of [level] below a cell. */
    private fun farthestOfCells(level: Int, column: Int, row: Int): Long {
        var farthest = 0L
        val width = widths[level]
        for (y in 2 * row..minOf(2 * row + 1, levels[level].size / width - 1)) {
            for (x in 2 * column..minOf(2 * column + 1, width - 1)) {
                // One whose old key is no farther need not be brought up to date
                if (upperBound(levels[level][y * width + x]) > farthest) {
                    farthest = maxOf(farthest, farthest(level, x, y))
                }
            }
        }
        return farthest
    }

    /** The farthest key of a block's samples; counts who holds it. */
    private fun farthestOfSamples(column: Int, row: Int): Long {
        var farthest = 0L
        var count = 0
        val xStart = column * BLOCK
        val xEnd = minOf(xStart + BLOCK, region.width)
        for (y in row * BLOCK until minOf((row + 1) * BLOCK, region.height)) {
            for (at in y * region.width + xStart until y * region.width + xEnd) {
                val key = keys[at]
                if (key > farthest) {
                    farthest = key
                    count = 1
                } else if (key == farthest) {
                    count++
                }
            }
        }
        holders[row * widths[0] + column] = count.toByte()
        return farthest
    }

    companion object {
        /** Samples along a side of a block: those of a block fit a byte to count them. */
        const val BLOCK: Int = 8

        private const val MAX_SAMPLES = Int.MAX_VALUE - 8L

        /** The key that a cell holds, or held when it was last up to date. */
        private fun upperBound(cell: Long): Long = maxOf(cell, cell.inv())
    }
}
