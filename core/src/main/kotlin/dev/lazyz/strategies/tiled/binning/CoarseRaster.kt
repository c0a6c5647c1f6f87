package dev.lazyz.strategies.tiled.binning

import dev.lazyz.raster.Edge
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.strategies.tiled.raster.TileGrid

/** The coarse raster: the tiles of [area] that a triangle reaches. Reused for each triangle; belongs to one thread. */
internal class CoarseRaster(private val area: BinArea, private val grid: TileGrid) {
    private var ax = 0
    private var ay = 0
    private var bx = 0
    private var by = 0
    private var cx = 0
    private var cy = 0
    private var firstColumn = 0
    private var lastColumn = 0
    private var firstBand = 0
    private var lastBand = 0

    /** Whether the bounds are one tile wide or high. Testing edges against tiles then rejects little. */
    private var isOne = false

    /**
     * Begins a triangle. Returns the number of tiles that its bounds reach within the bands number [bandStart] until
     * [bandEnd] of the area. If it is 0, [forEach] must not be called.
     */
    fun begin(batch: TriangleBatch, triangle: Int, bandStart: Int = 0, bandEnd: Int = area.bands): Int {
        batch.vertices(triangle) { x0, y0, x1, y1, x2, y2 ->
            ax = x0
            ay = y0
            bx = x1
            by = y1
            cx = x2
            cy = y2
        }
        var tiles = 0
        ScreenGrid.bounds(ax, ay, bx, by, cx, cy) { columnStart, rowStart, columnEnd, rowEnd ->
            val left = maxOf(columnStart, area.columnStart)
            val right = minOf(columnEnd, area.columnEnd)
            val top = maxOf(rowStart, area.rowStart)
            val bottom = minOf(rowEnd, area.rowEnd)
            if (left < right && top < bottom) tiles = begin(left, top, right, bottom, bandStart, bandEnd)
        }
        return tiles
    }

    private fun begin(left: Int, top: Int, right: Int, bottom: Int, bandStart: Int, bandEnd: Int): Int {
        firstColumn = grid.columnOf(left)
        lastColumn = grid.columnOf(right - 1)
        firstBand = grid.bandOf(top)
        lastBand = grid.bandOf(bottom - 1)
        isOne = firstColumn == lastColumn || firstBand == lastBand
        firstBand = maxOf(firstBand, area.band(bandStart))
        lastBand = minOf(lastBand, area.band(bandEnd) - 1)
        return maxOf(0, (lastColumn - firstColumn + 1) * (lastBand - firstBand + 1))
    }

    /**
     * Calls [action] for each of these tiles, except those where [isHidden] returns true or which lie entirely outside
     * one edge. `isCovered` is true only if the triangle covers all samples of the tile.
     */
    inline fun forEach(isHidden: (tile: Int) -> Boolean, action: (tile: Int, isCovered: Boolean) -> Unit) {
        val sign = if (Edge.function(ax, ay, bx, by, cx, cy) < 0) -1L else 1L
        var first0 = greatest(sign, ax, ay, bx, by)
        var first1 = greatest(sign, bx, by, cx, cy)
        var first2 = greatest(sign, cx, cy, ax, ay)
        val range0 = range(ax, ay, bx, by)
        val range1 = range(bx, by, cx, cy)
        val range2 = range(cx, cy, ax, ay)
        val step = sign * grid.size * ScreenGrid.STEPS
        for (band in firstBand..lastBand) {
            var e0 = first0
            var e1 = first1
            var e2 = first2
            for (column in firstColumn..lastColumn) {
                val tile = area.tile(band, column)
                if (!isHidden(tile) && (isOne || (e0 or e1 or e2) >= 0)) {
                    action(tile, (e0 - range0 or (e1 - range1) or (e2 - range2)) >= 0)
                }
                e0 -= step * (by - ay)
                e1 -= step * (cy - by)
                e2 -= step * (ay - cy)
            }
            first0 += step * (bx - ax)
            first1 += step * (cx - bx)
            first2 += step * (ax - cx)
        }
    }

    /** Returns the greatest value of an edge function in the first tile, assuming that the tile is complete. */
    fun greatest(sign: Long, fromX: Int, fromY: Int, toX: Int, toY: Int): Long {
        val runX = sign * (toX - fromX)
        val runY = sign * (toY - fromY)
        val x = grid.columnStart(firstColumn) + if (runY < 0) grid.size - 1 else 0
        val y = grid.rowStart(firstBand) + if (runX > 0) grid.size - 1 else 0
        val sampleX = x * ScreenGrid.STEPS + ScreenGrid.CENTER
        val sampleY = y * ScreenGrid.STEPS + ScreenGrid.CENTER
        return sign * Edge.function(fromX, fromY, toX, toY, sampleX, sampleY)
    }

    /**
     * Returns the least value for which this holds: if an edge function's greatest value in a tile is at least this,
     * all samples of the tile are inside the edge, whether or not the edge owns the samples on it.
     */
    fun range(fromX: Int, fromY: Int, toX: Int, toY: Int): Long =
        (grid.size - 1L) * ScreenGrid.STEPS * (Math.abs((toX - fromX).toLong()) + Math.abs((toY - fromY).toLong())) + 1
}
