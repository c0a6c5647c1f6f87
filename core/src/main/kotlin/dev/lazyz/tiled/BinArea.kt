package dev.lazyz.tiled

import dev.lazyz.setup.ScreenGrid
import dev.lazyz.setup.TriangleBatch

/** The tiles that bins are made for: those of the bands [bandStart] until [bandEnd]. Immutable. */
internal class BinArea(private val grid: TileGrid, private val bandStart: Int, bandEnd: Int) {
    /** The samples of these tiles. */
    @JvmField val columnStart: Int = grid.region.columnStart

    @JvmField val columnEnd: Int = grid.region.columnEnd

    @JvmField val rowStart: Int = grid.rowStart(bandStart)

    @JvmField val rowEnd: Int = grid.rowEnd(bandEnd - 1)
    private val columns = grid.columns

    /** Number of tiles. */
    val tiles: Int = (bandEnd - bandStart) * columns

    /** The number of a tile. */
    fun tile(band: Int, column: Int): Int = (band - bandStart) * columns + column

    /** The number of the tile that a sample is in. */
    fun tileAt(x: Int, y: Int): Int = tile(grid.bandOf(y), grid.columnOf(x))

    /** Where a sample is in its tile, whose rows have [stride] places. */
    fun placeInTile(x: Int, y: Int, stride: Int): Int = grid.rowInTile(y) * stride + grid.columnInTile(x)

    /** Calls [action] for each tile that the bounds of a triangle reach, unless one of its edges has the tile outside. */
    inline fun forEachTile(batch: TriangleBatch, triangle: Int, action: (tile: Int) -> Unit) {
        val a = batch.place(triangle, 0)
        val b = batch.place(triangle, 1)
        val c = batch.place(triangle, 2)
        val ax = batch.grid[a]
        val ay = batch.grid[a + 1]
        val bx = batch.grid[b]
        val by = batch.grid[b + 1]
        val cx = batch.grid[c]
        val cy = batch.grid[c + 1]
        val left = maxOf(ScreenGrid.firstSample(minOf(ax, minOf(bx, cx))), columnStart)
        val right = minOf(ScreenGrid.firstSample(maxOf(ax, maxOf(bx, cx))), columnEnd)
        val top = maxOf(ScreenGrid.firstSample(minOf(ay, minOf(by, cy))), rowStart)
        val bottom = minOf(ScreenGrid.firstSample(maxOf(ay, maxOf(by, cy))), rowEnd)
        if (left >= right || top >= bottom) return
        val firstColumn = grid.columnOf(left)
        val lastColumn = grid.columnOf(right - 1)
        val firstBand = grid.bandOf(top)
        val lastBand = grid.bandOf(bottom - 1)
        val isClockwise = (bx - ax).toLong() * (cy - ay) - (cx - ax).toLong() * (by - ay) >= 0
        val sign = if (isClockwise) 1L else -1L
        var first0 = greatest(sign, ax, ay, bx, by, firstColumn, firstBand)
        var first1 = greatest(sign, bx, by, cx, cy, firstColumn, firstBand)
        var first2 = greatest(sign, cx, cy, ax, ay, firstColumn, firstBand)
        val step = sign * grid.size * ScreenGrid.STEPS
        val isOne = lastColumn == firstColumn || lastBand == firstBand
        for (band in firstBand..lastBand) {
            var e0 = first0
            var e1 = first1
            var e2 = first2
            for (column in firstColumn..lastColumn) {
                if (isOne || (e0 or e1 or e2) >= 0) action(tile(band, column))
                e0 -= step * (by - ay)
                e1 -= step * (cy - by)
                e2 -= step * (ay - cy)
            }
            first0 += step * (bx - ax)
            first1 += step * (cx - bx)
            first2 += step * (ax - cx)
        }
    }

    /** Returns the most that the edge function is anywhere in a tile, as if the tile were whole. */
    fun greatest(sign: Long, fromX: Int, fromY: Int, toX: Int, toY: Int, column: Int, band: Int): Long {
        val runX = sign * (toX - fromX)
        val runY = sign * (toY - fromY)
        val x = grid.columnStart(column) + if (runY < 0) grid.size - 1 else 0
        val y = grid.rowStart(band) + if (runX > 0) grid.size - 1 else 0
        return runX * (y * ScreenGrid.STEPS + ScreenGrid.CENTER - fromY) -
            runY * (x * ScreenGrid.STEPS + ScreenGrid.CENTER - fromX)
    }
}
