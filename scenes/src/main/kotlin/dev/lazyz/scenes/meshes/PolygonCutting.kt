package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.loading.Source

/**
 * Cuts polygons into triangles, and leaves out those with missing vertices. Not thread safe.
 *
 * @param vertexCount number of vertices that exist
 * @param coordinate returns a coordinate of a vertex
 */
internal class PolygonCutting(
    private val source: Source,
    private val vertexCount: Int,
    private val coordinate: (vertex: Int, axis: Int) -> Float,
) {
    private val warnings = ArrayList<String>()
    private var withoutVertices = 0

    /**
     * Calls [use] for each corner of the triangles of polygon [number] of [polygons], with its number among the corners
     * of all polygons.
     */
    inline fun cut(polygons: Polygons, number: Int, use: (corner: Int) -> Unit) {
        val start = polygons.start(number)
        val end = polygons.end(number)
        if (!haveVertices(polygons, start, end)) return
        if (end - start == 3) {
            for (corner in start until end) use(corner)
        } else {
            for (corner in cornersOf(polygons, start, end - start)) use(start + corner)
        }
    }

    /** Reports the polygons that were left out. */
    fun warn() {
        for (warning in warnings) source.warn(warning)
        if (withoutVertices > 0) {
            source.warn("$withoutVertices faces are left out, because some of their vertices are missing")
        }
    }

    fun haveVertices(polygons: Polygons, from: Int, until: Int): Boolean {
        for (corner in from until until) {
            if (polygons.vertex(corner) < vertexCount) continue
            withoutVertices++
            return false
        }
        return true
    }

    fun cornersOf(polygons: Polygons, start: Int, count: Int): IntArray {
        val local = Triangulation.triangles(
            DoubleArray(3 * count) { coordinate(polygons.vertex(start + it / 3), it % 3).toDouble() },
        )
        if (local != null) return local
        val most = Triangulation.MAX_CONCAVE_CORNERS
        warnings += "a concave face of $count corners, more than $most, is left out"
        return IntArray(0)
    }
}
