package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source

/**
 * Triangulates polygons, and leaves out those whose vertices are missing. Not thread safe.
 *
 * @param vertexCount number of vertices that are there
 * @param positions the positions of the vertices
 */
internal class PolygonCutting(
    private val source: Source,
    private val vertexCount: Int,
    private val positions: VertexPositions,
) {
    private var withoutVertices = 0

    /** Adds the corners of the triangles of [polygon] to [corners], as numbers among the corners of all [polygons]. */
    fun cut(polygons: Polygons, polygon: Int, corners: Ints) {
        val start = polygons.start(polygon)
        val count = polygons.end(polygon) - start
        source.step(count)
        if (!haveVertices(polygons, start, count)) {
            withoutVertices++
        } else if (count == 3) {
            corners.add(start, start + 1, start + 2)
        } else {
            val isSmall = count <= Triangulation.MAX_CORNERS
            val local = if (isSmall) Triangulation.triangles(xyz(polygons, start, count), source::step) else null
            if (local == null) {
                source.warn("", "a face of $count corners", ", ${Triangulation.TOO_MANY}, is left out")
            } else {
                for (corner in local) corners.add(start + corner)
            }
        }
    }

    private fun xyz(polygons: Polygons, start: Int, count: Int): DoubleArray =
        DoubleArray(3 * count) { positions.get(polygons.vertex(start + it / 3), it % 3).toDouble() }

    private fun haveVertices(polygons: Polygons, start: Int, count: Int): Boolean {
        for (corner in start until start + count) if (polygons.vertex(corner) >= vertexCount) return false
        return true
    }

    /** Reports the polygons without vertices. */
    fun warn() {
        if (withoutVertices > 0) {
            source.warn("$withoutVertices faces are left out, because some of their vertices are missing")
        }
    }
}

/** Positions by number. */
internal fun interface VertexPositions {
    /** Returns coordinate [axis], 0..2, of [vertex]. */
    fun get(vertex: Int, axis: Int): Float
}
