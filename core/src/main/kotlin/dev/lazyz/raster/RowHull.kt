package dev.lazyz.raster

/** The range from the first to the last sample of row [y] that any of several shapes on the 1/256 pixel grid covers. */
internal class RowHull(private val y: Int) {
    /** First column. */
    var start: Int = Int.MAX_VALUE
        private set

    /** The column after the last. */
    var end: Int = Int.MIN_VALUE
        private set

    /** Columns of the crossings of the current shape. */
    private var left = Int.MAX_VALUE
    private var right = Int.MIN_VALUE

    /** Adds an edge of a convex shape, which has either two edges that cross the row or none (contract rule 2.1). */
    fun addEdge(fromX: Int, fromY: Int, toX: Int, toY: Int) {
        val isDown = fromY < toY
        val upperX = if (isDown) fromX else toX
        val upperY = if (isDown) fromY else toY
        val lowerX = if (isDown) toX else fromX
        val lowerY = if (isDown) toY else fromY
        if (y < ScreenGrid.firstSample(upperY) || y >= ScreenGrid.firstSample(lowerY)) return
        val runY = lowerY - upperY
        val crossing = Edge.crossing(upperX, upperY, lowerX - upperX, runY, y)
        val column = EdgeTable.ceilDiv(crossing, ScreenGrid.STEPS * runY.toLong()).toInt()
        left = minOf(left, column)
        right = maxOf(right, column)
    }

    /**
     * Adds the samples between the crossings of the edges added so far. These edges must form a single convex shape.
     */
    fun endShape() {
        if (left < right) add(left, right)
    }

    /** Adds the sample that a square of one pixel around a grid point covers, if it is in this row. */
    fun addPixel(pointX: Int, pointY: Int) {
        if (ScreenGrid.firstSample(pointY - ScreenGrid.CENTER) != y) return
        val column = ScreenGrid.firstSample(pointX - ScreenGrid.CENTER)
        add(column, column + 1)
    }

    /** Adds the columns [from] until [until]; nothing if the range is empty. */
    fun addColumns(from: Int, until: Int) {
        if (from < until) add(from, until)
    }

    private fun add(from: Int, until: Int) {
        start = minOf(start, from)
        end = maxOf(end, until)
    }
}
