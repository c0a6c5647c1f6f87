package dev.lazyz.tiled

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Raster

/**
 * The visibility keys of one tile, and the kernels that lower them. Belongs to one thread; used for tile after tile.
 *
 * Rejection is by whole primitives only. Tried: the farthest key of each row of the tile as well, against the nearest
 * end of each span. In the city at 1024 x 1024 that saved 8 percent of the depth evaluations, and what it took to know
 * the keys was more: 3 percent of the time there, 40 percent with layers from back to front.
 */
internal class TileKeys(grid: TileGrid, raster: Raster, private val counters: Counters) {
    private val test = raster.depthTest
    private val background = test.key(raster.backgroundDepth, DepthTest.BACKGROUND)
    private val stride = grid.tileWidth
    private val keys = LongArray(grid.tileWidth * grid.tileHeight)

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

    /** What none of the keys is behind; and what has been done since that was found out. */
    private var farthest = background
    private var comparisons = 0
    private var hasChanged = false

    /** What is drawn. */
    private var primitive: Primitive? = null
    private var form: LinearForm? = null
    private var origin = 0L

    /** Bytes held. */
    val bytes: Long get() = Long.SIZE_BYTES * keys.size.toLong()

    /** Begins a tile: nothing but background. */
    fun begin(columnStart: Int, columnEnd: Int, rowStart: Int, rowEnd: Int) {
        this.columnStart = columnStart
        this.columnEnd = columnEnd
        this.rowStart = rowStart
        this.rowEnd = rowEnd
        keys.fill(background, 0, (rowEnd - rowStart) * stride)
        farthest = background
        comparisons = 0
        hasChanged = false
    }

    /** Number of places for keys, see [place]. */
    val size: Int get() = keys.size

    /** Returns the place of a sample of the tile, 0 until [size]. */
    fun place(x: Int, y: Int): Int = (y - rowStart) * stride + (x - columnStart)

    /** Returns the key at a sample of the tile. */
    fun at(x: Int, y: Int): Long = keys[place(x, y)]

    /**
     * Returns a key that none of the tile's is behind: a fragment that is not before it is hidden.
     *
     * It is the greatest key when last looked for. That is again when there have been as many comparisons as there are
     * samples, so that looking costs less than what has been drawn since.
     */
    fun farthest(): Long {
        if (!hasChanged || comparisons < (columnEnd - columnStart) * (rowEnd - rowStart)) return farthest
        farthest = Long.MIN_VALUE
        for (row in 0 until rowEnd - rowStart) {
            for (at in row * stride until row * stride + (columnEnd - columnStart)) {
                farthest = maxOf(farthest, keys[at])
            }
        }
        comparisons = 0
        hasChanged = false
        return farthest
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
        comparisons += until - from
        if (passes > 0) hasChanged = true
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
            val key = (z and DEPTH_BITS) xor origin
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

    private companion object {
        /** The upper half of a key, and of a linear form. */
        const val DEPTH_BITS = -1L shl Int.SIZE_BITS
    }
}
