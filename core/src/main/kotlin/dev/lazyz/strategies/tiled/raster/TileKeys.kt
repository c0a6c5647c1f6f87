package dev.lazyz.strategies.tiled.raster

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Raster

/**
 * The visibility keys of one tile, and what is known of them block by block. Belongs to one thread; used for tile after
 * tile.
 *
 * Rows and columns are filled up to whole blocks. What lies outside the picture there has the least key of all: nothing
 * is ever drawn to it, and it is never the farthest.
 */
internal class TileKeys(grid: TileGrid, raster: Raster, private val counters: Counters) {
    private val test = raster.depthTest
    private val background = test.key(raster.backgroundDepth, DepthTest.BACKGROUND)

    /** Columns of blocks. */
    val blockColumns: Int = (grid.tileWidth - 1) / BlockKernel.BLOCK + 1
    private val blockRows = (grid.tileHeight - 1) / BlockKernel.BLOCK + 1

    /** Keys of a row. */
    val stride: Int = stride(grid)

    /** The keys, row by row. */
    val keys: LongArray = LongArray(stride * blockRows * BlockKernel.BLOCK)

    /** For each block a key that none of the block's is behind. */
    val farthestOfBlock: LongArray = LongArray(blockColumns * blockRows)

    /** First column of the tile. */
    var columnStart: Int = 0
        private set

    /** The column after its last. */
    var columnEnd: Int = 0
        private set

    /** Its first row. */
    var rowStart: Int = 0
        private set

    /** The row after its last. */
    var rowEnd: Int = 0
        private set

    /** What none of the keys is behind. */
    private var farthest = background

    /** The block where it was found: while that has it, the bound is exact. */
    private var farthestBlock = 0

    /** Keys compared since blocks were last looked through, but for those whose block was looked through at once. */
    private var comparisons = 0

    /** What is drawn. */
    private var primitive: Primitive? = null
    private var form: LinearForm? = null
    private var origin = 0L

    /** Bytes held. */
    val bytes: Long get() = Long.SIZE_BYTES * (keys.size + farthestOfBlock.size).toLong()

    /** Begins a tile: nothing but background. */
    fun begin(columnStart: Int, columnEnd: Int, rowStart: Int, rowEnd: Int) {
        this.columnStart = columnStart
        this.columnEnd = columnEnd
        this.rowStart = rowStart
        this.rowEnd = rowEnd
        keys.fill(background, 0, (rowEnd - rowStart) * stride)
        keys.fill(NOT_THERE, (rowEnd - rowStart) * stride, keys.size)
        if (columnEnd - columnStart < stride) {
            for (row in 0 until rowEnd - rowStart) {
                keys.fill(NOT_THERE, row * stride + columnEnd - columnStart, (row + 1) * stride)
            }
        }
        farthestOfBlock.fill(background)
        farthest = background
        farthestBlock = 0
        comparisons = 0
    }

    /** Number of places for keys, see [place]. */
    val size: Int get() = keys.size

    /** Returns the place of a sample of the tile, 0 until [size]. */
    fun place(x: Int, y: Int): Int = (y - rowStart) * stride + (x - columnStart)

    /** Returns the key at a sample of the tile. */
    fun at(x: Int, y: Int): Long = keys[place(x, y)]

    /** Returns a key that none of the tile's is behind: a fragment that is not before it is hidden. */
    fun farthest(): Long {
        lookThroughIfDue()
        if (farthestOfBlock[farthestBlock] != farthest) {
            farthest = NOT_THERE
            for (block in farthestOfBlock.indices) {
                if (farthestOfBlock[block] > farthest) {
                    farthest = farthestOfBlock[block]
                    farthestBlock = block
                }
            }
        }
        return farthest
    }

    /**
     * Notes that [count] keys have been compared without bringing [farthestOfBlock] up to date.
     */
    fun compared(count: Int) {
        comparisons += count
    }

    /**
     * Brings [farthestOfBlock] up to date if as many keys have been compared as a quarter of the samples: so looking costs
     * less than what was drawn since.
     */
    fun lookThroughIfDue() {
        if (comparisons * 4 >= (columnEnd - columnStart) * (rowEnd - rowStart)) lookThrough()
    }

    private fun lookThrough() {
        for (row in 0 until blockRows) {
            for (column in 0 until blockColumns) {
                var most = NOT_THERE
                var at = row * BlockKernel.BLOCK * stride + column * BlockKernel.BLOCK
                for (line in 0 until BlockKernel.BLOCK) {
                    for (i in at until at + BlockKernel.BLOCK) most = maxOf(most, keys[i])
                    at += stride
                }
                farthestOfBlock[row * blockColumns + column] = most
            }
        }
        comparisons = 0
    }

    /** Chooses what [draw] draws: [primitive], with submission index [index]. */
    fun choose(primitive: Primitive, index: Int) {
        this.primitive = primitive
        form = primitive.depthForm
        origin = test.key(0, index)
    }

    /** Draws a span of the chosen primitive on row [y], as far as it is within the tile. */
    fun draw(y: Int, start: Int, end: Int) {
        val from = maxOf(start, columnStart)
        val until = minOf(end, columnEnd)
        if (from >= until) return
        val at = place(from, y)
        val form = form
        val passes = if (form != null) {
            lower(at, until - from, form.at(from, y), form.dx, origin)
        } else {
            lowerOneByOne(at, until - from, from, y)
        }
        counters.depthEvaluations += until - from
        counters.depthPasses += passes
        compared(until - from)
    }

    /**
     * Lowers [count] keys from [first] on to those of a primitive whose form has the value [value] at the first sample.
     *
     * A key is that of depth 0, and depth in its upper half: as it is, or, where the greatest depth wins, with all bits
     * turned round, for 2^31-1 - depth turns them round. Returns how many keys were lowered.
     */
    private fun lower(first: Int, count: Int, value: Long, step: Long, origin: Long): Int {
        val keys = keys
        var z = value
        var passes = 0
        for (at in first until first + count) {
            val key = (z and BlockKernel.DEPTH_BITS) xor origin
            if (key < keys[at]) {
                keys[at] = key
                passes++
            }
            z += step
        }
        return passes
    }

    /** As [lower], where depth is no linear form, from column [x] of row [y] on. */
    private fun lowerOneByOne(first: Int, count: Int, x: Int, y: Int): Int {
        val primitive = primitive!!
        var passes = 0
        for (i in 0 until count) {
            val key = (primitive.depth(x + i, y).toLong() shl Int.SIZE_BITS) xor origin
            if (key < keys[first + i]) {
                keys[first + i] = key
                passes++
            }
        }
        return passes
    }

    companion object {
        /** Returns the number of keys of a row, that of samples filled up to whole blocks. */
        fun stride(grid: TileGrid): Int = ((grid.tileWidth - 1) / BlockKernel.BLOCK + 1) * BlockKernel.BLOCK

        /** Before all keys. */
        private const val NOT_THERE = -1L
    }
}
