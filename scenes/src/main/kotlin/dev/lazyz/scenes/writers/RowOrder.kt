package dev.lazyz.scenes.writers

import java.io.IOException

/** Watches that rows come in order. The first may have any number, for a picture may be a part of a larger raster. */
internal class RowOrder(private val height: Int) {
    private var firstRow = 0

    /** Number of rows that have come. */
    var taken: Int = 0
        private set

    fun take(y: Int) {
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
