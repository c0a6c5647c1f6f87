package dev.lazyz.scenes.writers

import java.io.Closeable
import java.io.IOException

/**
 * Checks that rows arrive in order and have enough columns. The first row may have any number from 0 on, because an
 * image can be a part of a larger raster.
 *
 * @throws IllegalArgumentException if the image has no pixel, or too many columns
 */
internal class RowOrder(private val width: Int, private val height: Int) {
    private var firstRow = 0
    private var isClosed = false

    init {
        require(width > 0 && height > 0) { "an image must have at least one pixel: $width x $height" }
        require(width <= MAX_WIDTH) { "width must be at most $MAX_WIDTH: $width" }
    }

    /** Number of rows received. */
    var taken: Int = 0
        private set

    /**
     * Checks and counts row [y], of which a sink reads [values].
     *
     * @throws IllegalArgumentException if [y] does not follow the previous row, or the row has too few columns
     */
    fun take(y: Int, values: IntArray) {
        require(values.size >= width) { "row $y has ${values.size} columns, and the image has $width" }
        require(y >= 0) { "the number of a row must not be negative: $y" }
        if (taken == 0) firstRow = y
        require(taken < height) { "there are only $height rows: row $y" }
        require(y == firstRow + taken) { "rows must come in order from the top: $y instead of ${firstRow + taken}" }
        taken++
    }

    fun requireComplete() {
        if (taken < height) throw IOException("the image is incomplete: $taken of $height rows")
    }

    /** Closes [output], after [last] has ended the file, unless rows are missing. Closing again does nothing. */
    fun close(output: Closeable, last: () -> Unit = {}) {
        if (isClosed) return
        isClosed = true
        output.use {
            requireComplete()
            last()
        }
    }

    override fun toString(): String = "$taken rows written"

    private companion object {
        const val MAX_WIDTH = 1 shl 28
    }
}
