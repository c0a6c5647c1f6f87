package dev.lazyz.drawing.strokes

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.raster.ScreenGrid

/**
 * What all strokes of one kind share. Immutable.
 *
 * @property depth depth of all strokes
 * @param width pixels
 */
internal class Pen(val raster: Raster, val color: Rgba, val depth: Int, width: Double) {
    /** Half the width, grid steps. */
    val half: Int = ScreenGrid.half(width)

    /** Returns the strokes along a polyline, given as x and y of its points in turn, pixels. */
    fun strokes(line: DoubleArray): List<Stroke> {
        val strokes = ArrayList<Stroke>(line.size / 2)
        var x = ScreenGrid.snap(line[0])
        var y = ScreenGrid.snap(line[1])
        for (i in 2 until line.size step 2) {
            val nextX = ScreenGrid.snap(line[i])
            val nextY = ScreenGrid.snap(line[i + 1])
            if ((nextX == x && nextY == y) && (i < line.size - 2 || strokes.isNotEmpty())) continue
            strokes += Stroke(this, x, y, nextX, nextY)
            x = nextX
            y = nextY
        }
        return strokes
    }
}
