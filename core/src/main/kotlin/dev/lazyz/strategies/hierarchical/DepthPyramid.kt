package dev.lazyz.strategies.hierarchical

import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.bytes

/**
 * The visibility keys of a region's samples, and above them a pyramid with the farthest key of each block.
 *
 * A block is a square of [BLOCK] x [BLOCK] samples. A cell of a level combines four cells of the level below, and the
 * top level is one cell. A fragment that is behind a cell's key is hidden everywhere in the cell.
 *
 * Keys of samples only decrease, and therefore the keys of cells only decrease too. An outdated cell thus still holds
 * an upper bound, and a fragment behind that bound is also hidden: a cell is updated only if its old key does not
 * decide. A block counts the samples that hold its farthest key. When the last of them is replaced, the block becomes
 * outdated, together with those cells above it that have the same key.
 *
 * Source: Ned Greene, Michael Kass, Gavin Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993, on the image-space
 * Z pyramid. In the paper, the samples are the lowest level, and a change is propagated to the top immediately.
 *
 * @property region the region of the samples
 * @param background the initial key of all samples
 */
internal class DepthPyramid(val region: Region, background: Long) {
    /** The least key so far of each sample, in rows from the region's top. After replacing keys, call [replaced]. */
    val keys: LongArray

    /**
     * Keys of the cells in rows from the top; level 0 holds the blocks. An outdated cell holds the complement of its
     * key, which is negative.
     */
    private val levels: Array<LongArray>

    /** Number of cells in a row of each level. */
    private val widths: IntArray

    /** For each block that is up to date, the number of samples that hold its farthest key. */
    private val holders: ByteArray

    /** Number of cells tested so far. */
    var looks: Long = 0
        private set

    /** Number of levels, including that of the blocks. */
    val levelCount: Int get() = levels.size

    /** Bytes held. */
    val bytes: Long get() = keys.bytes + levels.sumOf { it.bytes } + holders.size

    init {
        require(region.size <= Image.MAX_SAMPLES) {
            "the depth pyramid holds at most ${Image.MAX_SAMPLES} samples: $region"
        }
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

    /** Whether fragments with the key [nearest] or greater are hidden at every sample of a rectangle of blocks. */
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

    /** Whether fragments with the key [nearest] or greater are hidden at every sample of a cell. */
    fun isHidden(nearest: Long, level: Int, column: Int, row: Int): Boolean {
        looks++
        val cell = levels[level][row * widths[level] + column]
        return nearest > upperBound(cell) || (cell < 0 && nearest > farthest(level, column, row))
    }

    /** Returns the farthest key of a block, or an upper bound of it if the block is outdated. */
    fun upperBound(column: Int, row: Int): Long = upperBound(levels[0][row * widths[0] + column])

    /** Whether the block is up to date: its key is the farthest of its samples. */
    fun isCurrent(column: Int, row: Int): Boolean = levels[0][row * widths[0] + column] >= 0

    /** Records that [count] samples of an up-to-date block held its farthest key and now hold lesser keys. */
    fun replaced(column: Int, row: Int, count: Int) {
        val block = row * widths[0] + column
        val left = holders[block] - count
        holders[block] = left.toByte()
        if (left > 0) return

        // No sample holds the key any more; the cells above that took it from this block are outdated, too
        val farthest = levels[0][block]
        for (level in levels.indices) {
            val at = (row shr level) * widths[level] + (column shr level)
            if (levels[level][at] != farthest) return
            levels[level][at] = farthest.inv()
        }
    }

    /** Returns the farthest key of a cell, after updating it. */
    private fun farthest(level: Int, column: Int, row: Int): Long {
        val at = row * widths[level] + column
        val known = levels[level][at]
        if (known >= 0) return known
        val farthest = if (level == 0) farthestOfSamples(column, row) else farthestOfCells(level - 1, column, row)
        levels[level][at] = farthest
        return farthest
    }

    /** Returns the farthest key of the four cells of [level] below a cell. */
    private fun farthestOfCells(level: Int, column: Int, row: Int): Long {
        var farthest = 0L
        val width = widths[level]
        for (y in 2 * row..minOf(2 * row + 1, levels[level].size / width - 1)) {
            for (x in 2 * column..minOf(2 * column + 1, width - 1)) {
                // A cell whose old key is not farther need not be updated
                if (upperBound(levels[level][y * width + x]) > farthest) {
                    farthest = maxOf(farthest, farthest(level, x, y))
                }
            }
        }
        return farthest
    }

    /** Returns the farthest key of a block's samples, and counts the samples that hold it. */
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
        /** Samples along a side of a block; the number of samples of a block fits into a byte. */
        const val BLOCK: Int = 8

        /** The key that a cell holds or, if it is outdated, held before. */
        private fun upperBound(cell: Long): Long = maxOf(cell, cell.inv())
    }
}
