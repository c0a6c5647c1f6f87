package dev.lazyz.filter

import dev.lazyz.Raster
import dev.lazyz.filter.LightSums.CHANNELS
import dev.lazyz.filter.SuperSampling.PixelFilter
import java.io.IOException

/**
 * Makes smaller copies of a picture while its rows pass: each level is half as wide and half as high as the one below
 * it, rounded up, until a level has one pixel.
 *
 * ```
 * val pyramid = BoxPyramid(width, height) { level, y, argb -> save(level, y, argb) }
 * renderer.render(frame) { _, argb, _, _ -> pyramid.add(argb) }
 * ```
 *
 * Level 0 is the picture itself. A pixel of level k is the mean of the pixels of the picture that it covers, 2^k x 2^k
 * of them, or fewer at the right and the lower edge: the mean of light, weighted by alpha, as for [SuperSampling] with
 * [PixelFilter.BOX]. It is not made of the rounded pixels of the level below, but of their sums: these are integers,
 * exact up to level 15; from there on, they keep 60 bits. So each level is rounded once. A pixel without alpha has the
 * colour of its upper left pixel.
 *
 * Rows of a level are passed on as soon as they are complete. Memory: 40 bytes a column of the picture, whatever its
 * height. Time: one pass over the pixels. Not thread safe.
 *
 * @property width columns of the picture, 1..[Raster.MAX_SIDE]
 * @property height rows of the picture, 1..[Raster.MAX_SIDE]
 * @param sink receives the rows of all levels
 * @throws IllegalArgumentException if a side is out of range
 */
public class BoxPyramid(public val width: Int, public val height: Int, private val sink: LevelSink) {
    init {
        require(width in 1..Raster.MAX_SIDE) { "width must be in 1..${Raster.MAX_SIDE}: $width" }
        require(height in 1..Raster.MAX_SIDE) { "height must be in 1..${Raster.MAX_SIDE}: $height" }
    }

    /** Number of levels, 1..19. */
    public val levels: Int = levels(width, height)

    /** Levels 1 and above. */
    private val upper = List(levels - 1) { Level(it + 1) }
    private var taken = 0

    /**
     * Adds the next row of the picture, `0xAARRGGBB`, from the top, and passes on the rows that are complete then.
     *
     * @throws IllegalArgumentException if there are no more rows, or [argb] has fewer than [width] elements
     * @throws IOException if the sink throws it
     */
    @Throws(IOException::class)
    public fun add(argb: IntArray) {
        require(taken < height) { "the picture has only $height rows" }
        require(argb.size >= width) { "row $taken has ${argb.size} columns, and the picture has $width" }
        val y = taken++
        sink.row(0, y, argb)
        if (upper.isEmpty()) return
        upper[0].add(y, argb)
        var level = 0
        while (level < upper.size && upper[level].isComplete) {
            val done = upper[level++]
            done.pass()
            if (level < upper.size) upper[level].add(done)
            done.begin()
        }
    }

    override fun toString(): String = "BoxPyramid($width x $height, $taken rows added)"

    /** The current row of level [number]. */
    private inner class Level(private val number: Int) {
        private val columns = side(width, number)
        private val rows = side(height, number)

        /** The row of the level, and the number of rows of the level below that it has. */
        private var y = 0
        private var added = 0
        private val sums = LongArray(CHANNELS * columns)

        /** By column, the upper left pixel of the level below. */
        private val corners = IntArray(columns)
        private val argb = IntArray(columns)

        val isComplete: Boolean get() = added == minOf(2, side(height, number - 1) - 2 * y)

        /** Adds row [row] of the picture: this is level 1. */
        fun add(row: Int, colors: IntArray) {
            keepCorners(colors)
            for (x in 0 until width) LightSums.add(sums, CHANNELS * (x / 2), colors[x], 1)
            added++
        }

        /** Adds the current row of the level [below]. */
        fun add(below: Level) {
            keepCorners(below.argb)
            val lost = if (number > EXACT_LEVELS) 2 else 0
            for (x in 0 until below.columns) {
                val from = CHANNELS * x
                val at = CHANNELS * (x / 2)
                for (channel in 0 until 3) sums[at + channel] += below.sums[from + channel] shr lost
                sums[at + 3] += below.sums[from + 3]
            }
            added++
        }

        private fun keepCorners(colors: IntArray) {
            if (added == 0) for (x in 0 until columns) corners[x] = colors[2 * x]
        }

        /** Passes the row to the sink. */
        fun pass() {
            val bits = LightSums.LIGHT_BITS - 2 * maxOf(number - EXACT_LEVELS, 0)
            val high = covered(height, y)
            for (x in 0 until columns) {
                argb[x] = LightSums.mean(sums, CHANNELS * x, high * covered(width, x), corners[x], bits)
            }
            sink.row(number, y, argb)
        }

        /** Begins the next row. */
        fun begin() {
            sums.fill(0)
            added = 0
            y++
        }

        /** Returns how many of the [total] columns or rows of the picture the column or row [at] covers. */
        private fun covered(total: Int, at: Int): Long = minOf(total - (at.toLong() shl number), 1L shl number)

        override fun toString(): String = "row $y of $rows of level $number"
    }

    /** Receives the rows of the levels of a [BoxPyramid], those of each level in order from the top. */
    public fun interface LevelSink {
        /**
         * Receives row [y] of level [level]; level 0 is the picture. The array belongs to the caller, is valid only
         * during this call, can be longer than the row, and must not be changed.
         *
         * @param argb colours, 8-bit sRGB with straight alpha, `0xAARRGGBB`
         * @throws IOException if the row cannot be written; it reaches the caller of [BoxPyramid.add]
         */
        @Throws(IOException::class)
        public fun row(level: Int, y: Int, argb: IntArray)
    }

    public companion object {
        /** The last level whose sums fit into 64 bits: 24 of light, 8 of alpha and 30 for the pixels. */
        private const val EXACT_LEVELS = 15

        /** Returns the number of levels of a picture: that of the single pixel is the last one. */
        @JvmStatic
        public fun levels(width: Int, height: Int): Int =
            1 + Int.SIZE_BITS - (maxOf(width, height) - 1).countLeadingZeroBits()

        /** Returns the width or height, on level [level], of a picture with this [side]. */
        @JvmStatic
        public fun side(side: Int, level: Int): Int = ((side.toLong() + (1L shl level) - 1) shr level).toInt()
    }
}
