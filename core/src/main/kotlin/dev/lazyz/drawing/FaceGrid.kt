package dev.lazyz.drawing

import dev.lazyz.Checkpoint

/**
 * The faces that can hide something, by their place on the raster: a pyramid of grids, each with twice as many cells a
 * side as the one before. A face is in the finest grid of which a cell is at least as large as the face, so it is in at
 * most four cells, and memory is linear in the number of faces. Immutable and thread safe.
 *
 * @param places four numbers for each point, see [ViewSpace.place]
 * @param polygons by polygon of the model: what it hides with; null if it hides nothing
 * @param checkpoint passed for each face while the grid is made
 * @param margin how far the grid extends beyond the raster, pixels
 */
internal class FaceGrid(
    private val space: ViewSpace,
    private val model: EdgeModel,
    facing: Facing,
    private val places: DoubleArray,
    private val polygons: List<HidingPolygon?>,
    margin: Double,
    private val checkpoint: Checkpoint,
) {
    private val left = -margin
    private val top = -margin
    private val width = space.raster.width + 2 * margin
    private val height = space.raster.height + 2 * margin
    private val levels: Int

    /** By cell of all levels: the index of its first face in [faces]. */
    private val starts: IntArray
    private val faces: IntArray

    // Bounds of the current face on the raster, as parts of the grid: 0..1
    private class Extent(var x0: Double = 0.0, var y0: Double = 0.0, var x1: Double = 0.0, var y1: Double = 0.0)

    init {
        // About as many cells as faces in the finest grid
        var finest = 0
        while (finest < FINEST && (1L shl 2 * finest) < model.faceCount) finest++
        levels = finest + 1
        val cells = first(levels)
        starts = IntArray(cells + 2)
        val extent = Extent()
        forEachCell(facing, extent) { cell, _ -> starts[cell + 2]++ }
        for (i in 2 until starts.size) starts[i] += starts[i - 1]
        faces = IntArray(starts[cells + 1])
        forEachCell(facing, extent) { cell, face -> faces[starts[cell + 1]++] = face }
    }

    /** The number of the first cell of [level]. */
    private fun first(level: Int): Int = ((1L shl 2 * level) / 3).toInt()

    private inline fun forEachCell(facing: Facing, extent: Extent, action: (cell: Int, face: Int) -> Unit) {
        for (face in 0 until model.faceCount) {
            checkpoint.pass()
            if (!facing.isHiding(face) || !measure(face, extent)) continue
            val size = maxOf(extent.x1 - extent.x0, extent.y1 - extent.y0)
            var level = 0
            while (level < levels - 1 && size * (2 shl level) <= 1.0) level++
            val side = 1 shl level
            for (row in cell(extent.y0, side)..cell(extent.y1, side)) {
                for (column in cell(extent.x0, side)..cell(extent.x1, side)) {
                    action(first(level) + row * side + column, face)
                }
            }
        }
    }

    private fun cell(place: Double, side: Int): Int = (place * side).toInt().coerceIn(0, side - 1)

    /** Sets [extent] to that of [face]; returns false if it is outside the grid. */
    private fun measure(face: Int, extent: Extent): Boolean {
        extent.x0 = Double.POSITIVE_INFINITY
        extent.y0 = Double.POSITIVE_INFINITY
        extent.x1 = Double.NEGATIVE_INFINITY
        extent.y1 = Double.NEGATIVE_INFINITY
        if (face < model.triangleCount) {
            for (k in 0 until 3) extend(extent, places, 4 * model.corners[3 * face + k])
        } else {
            val polygon = polygons[face - model.triangleCount] ?: return false
            for (contour in polygon.contours) for (at in contour.indices step 4) extend(extent, contour, at)
        }
        return extent.x0 <= 1.0 && extent.y0 <= 1.0 && extent.x1 >= 0.0 && extent.y1 >= 0.0
    }

    /** Extends [extent] to the vertex with the numbers at index [at] of [p]. */
    private fun extend(extent: Extent, p: DoubleArray, at: Int) {
        val w = p[at + 2]
        if (space.isPerspective && w < LEAST_W * space.far) {
            // The face reaches behind the camera, and can be anywhere
            extent.x0 = Double.NEGATIVE_INFINITY
            extent.y0 = Double.NEGATIVE_INFINITY
            extent.x1 = Double.POSITIVE_INFINITY
            extent.y1 = Double.POSITIVE_INFINITY
            return
        }
        val x = (p[at] / w - left) / width
        val y = (p[at + 1] / w - top) / height
        extent.x0 = minOf(extent.x0, x - ROUNDING)
        extent.x1 = maxOf(extent.x1, x + ROUNDING)
        extent.y0 = minOf(extent.y0, y - ROUNDING)
        extent.y1 = maxOf(extent.y1, y + ROUNDING)
    }

    /**
     * Calls [action] for each face that may cover a place on the line from ([x0], [y0]) to ([x1], [y1]), in pixels;
     * possibly several times for the same face.
     */
    inline fun forEachAlong(x0: Double, y0: Double, x1: Double, y1: Double, action: (face: Int) -> Unit) {
        val fromX = (x0 - left) / width
        val fromY = (y0 - top) / height
        val toX = (x1 - left) / width
        val toY = (y1 - top) / height
        val slope = (toX - fromX) / (toY - fromY)
        for (level in 0 until levels) {
            val side = 1 shl level
            val base = first(level)
            if (starts[base] == starts[base + side * side]) continue
            for (row in cell(minOf(fromY, toY), side)..cell(maxOf(fromY, toY), side)) {
                // The columns that the line reaches in this row
                var least = minOf(fromX, toX)
                var most = maxOf(fromX, toX)
                if (slope.isFinite()) {
                    val atTop = fromX + (row.toDouble() / side - fromY) * slope
                    val atBottom = fromX + ((row + 1.0) / side - fromY) * slope
                    least = maxOf(least, minOf(atTop, atBottom) - ROUNDING)
                    most = minOf(most, maxOf(atTop, atBottom) + ROUNDING)
                }
                for (column in cell(least, side)..cell(most, side)) {
                    val cell = base + row * side + column
                    for (i in starts[cell] until starts[cell + 1]) action(faces[i])
                }
            }
        }
    }

    companion object {
        private const val FINEST = 11

        /** Points nearer than this part of the distance of the far plane count as behind the camera. */
        private const val LEAST_W = 1e-9

        /** More than the rounding error of a place, as a part of the grid. */
        const val ROUNDING = 1e-9
    }
}
