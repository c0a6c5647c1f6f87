package dev.lazyz.scenes.writers

import java.io.IOException

/**
 * Checks that rows arrive in order and have enough columns. The first row may have any number from 0 on, because an
 * image can be a part of a larger raster.
 */
internal class RowOrder(private val width: Int, private val height: Int) {
    private var firstRow = 0

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

    override fun toString(): String = "$taken rows written"
}
