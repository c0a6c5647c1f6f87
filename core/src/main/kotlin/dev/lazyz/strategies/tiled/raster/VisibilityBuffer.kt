package dev.lazyz.strategies.tiled.raster

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.bytes
import dev.lazyz.spi.LinearForm

/**
 * The visibility keys of one tile, and bounds of them for each block. Belongs to one thread; reused for each tile.
 *
 * Rows and columns are padded to whole blocks. Places outside the picture have a key less than all others, so nothing
 * is ever drawn there, and they never hold the farthest key.
 */
internal class VisibilityBuffer(grid: TileGrid, raster: Raster, private val counters: Counters.Builder) {
    private val test = raster.depthTest
    private val background = test.key(raster.backgroundDepth, DepthTest.BACKGROUND)

    /** Columns of blocks. */
    val blockColumns: Int = (grid.tileWidth - 1) / BlockKernel.BLOCK + 1
    private val blockRows = (grid.tileHeight - 1) / BlockKernel.BLOCK + 1

    /** Number of keys in a row. */
    val stride: Int = stride(grid)

    /** The keys, row by row. */
    val keys: LongArray = LongArray(stride * blockRows * BlockKernel.BLOCK)

    /** For each block, an upper bound of its keys. */
    val farthestOfBlock: LongArray = LongArray(blockColumns * blockRows)

    /** First column of the tile. */
    var columnStart: Int = 0
        private set

    /** The column after the tile's last. */
    var columnEnd: Int = 0
        private set

    /** First row of the tile. */
    var rowStart: Int = 0
        private set

    /** The row after the tile's last. */
    var rowEnd: Int = 0
        private set

    /** An upper bound of all keys. */
    private var farthest = background

    /**
     * The block that the bound was taken from. As long as that block's bound does not change, [farthest] is current.
     */
    private var farthestBlock = 0

    /**
     * Number of keys compared since the block bounds were last updated, except comparisons that updated the bound of
     * their block.
     */
    private var comparisons = 0

    /** The primitive that [draw] draws. */
    private var primitive: Primitive? = null
    private var form: LinearForm? = null
    private var origin = 0L

    /** Bytes held. */
    val bytes: Long get() = keys.bytes + farthestOfBlock.bytes

    /** Begins a tile, filled with background. */
    fun begin(columnStart: Int, columnEnd: Int, rowStart: Int, rowEnd: Int) {
        this.columnStart = columnStart
        this.columnEnd = columnEnd
        this.rowStart = rowStart
        this.rowEnd = rowEnd
        keys.fill(background, 0, (rowEnd - rowStart) * stride)
        keys.fill(BEFORE_ALL, (rowEnd - rowStart) * stride, keys.size)
        if (columnEnd - columnStart < stride) {
            for (row in 0 until rowEnd - rowStart) {
                keys.fill(BEFORE_ALL, row * stride + columnEnd - columnStart, (row + 1) * stride)
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

    /** Returns an upper bound of the tile's keys: a fragment whose key is not less is hidden. */
    fun farthest(): Long {
        updateBlocksIfDue()
        if (farthestOfBlock[farthestBlock] != farthest) {
            farthest = BEFORE_ALL
            for (block in farthestOfBlock.indices) {
                if (farthestOfBlock[block] > farthest) {
                    farthest = farthestOfBlock[block]
                    farthestBlock = block
                }
            }
        }
        return farthest
    }

    /** Records that [count] keys were compared without updating [farthestOfBlock]. */
    fun compared(count: Int) {
        comparisons += count
    }

    /**
     * Updates [farthestOfBlock] if the number of compared keys is at least a quarter of the number of samples. An
     * update thus costs less than the drawing since the last one.
     */
    fun updateBlocksIfDue() {
        if (comparisons * 4 >= (columnEnd - columnStart) * (rowEnd - rowStart)) updateBlocks()
    }

    private fun updateBlocks() {
        for (row in 0 until blockRows) {
            for (column in 0 until blockColumns) {
                var most = BEFORE_ALL
                var at = row * BlockKernel.BLOCK * stride + column * BlockKernel.BLOCK
                for (line in 0 until BlockKernel.BLOCK) {
                    // Two halves, so that one comparison need not wait for the one before
                    for (i in at until at + HALF) most = maxOf(most, maxOf(keys[i], keys[i + HALF]))
                    at += stride
                }
                farthestOfBlock[row * blockColumns + column] = most
            }
        }
        comparisons = 0
    }

    /** Chooses the primitive that [draw] draws: [primitive], with submission index [index]. */
    fun choose(primitive: Primitive, index: Int) {
        this.primitive = primitive
        form = primitive.depthForm
        origin = test.key(0, index)
    }

    /** Draws the part of a span of the chosen primitive on row [y] that is within the tile. */
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
     * A key is that of depth 0, combined with the depth in its upper half. Where the greatest depth wins, the bits of
     * the depth are inverted, because 2^31-1 - depth inverts them. Returns the number of keys that were lowered.
     */
    fun lower(first: Int, count: Int, value: Long, step: Long, origin: Long): Int {
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

    /** Like [lower], where depth is not a linear form, from column [x] of row [y] on. */
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
        /** Returns the number of keys in a row: the number of samples, padded to whole blocks. */
        fun stride(grid: TileGrid): Int = ((grid.tileWidth - 1) / BlockKernel.BLOCK + 1) * BlockKernel.BLOCK

        private const val HALF = BlockKernel.BLOCK / 2

        /** Less than all keys. */
        private const val BEFORE_ALL = -1L
    }
}
