package dev.lazyz.scenes.ply

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.PolygonCutting
import dev.lazyz.scenes.meshes.Polygons
import dev.lazyz.scenes.streaming.FacetSpool
import dev.lazyz.scenes.streaming.VertexSpool

/**
 * Triangulates polygons and adds the triangles to [facets]. Not thread safe.
 *
 * @param hasFaceColors whether triangles get the colours of their polygons
 */
internal class PlyFacets(
    source: Source,
    private val vertices: VertexSpool,
    private val facets: FacetSpool,
    private val hasFaceColors: Boolean,
) {
    private val cutting = PolygonCutting(source, vertices.size, vertices)
    private val corners = Ints()
    private val color = FloatArray(4)

    fun add(polygons: Polygons) {
        for (polygon in 0 until polygons.count) {
            corners.clear()
            cutting.cut(polygons, polygon, corners)
            for (i in 0 until corners.size step 3) {
                vertices.addTo(
                    facets,
                    polygons.vertex(corners[i]),
                    polygons.vertex(corners[i + 1]),
                    polygons.vertex(corners[i + 2]),
                )
                if (hasFaceColors) addColor(polygons, polygons.colorOf(polygon))
            }
        }
    }

    private fun addColor(polygons: Polygons, number: Int) {
        if (number < 0) color.fill(1f) else polygons.colors.copy(number, color, 0)
        repeat(3) { facets.color(color[0], color[1], color[2], color[3]) }
    }

    /** Reports the polygons that were left out. */
    fun warn() = cutting.warn()
}
