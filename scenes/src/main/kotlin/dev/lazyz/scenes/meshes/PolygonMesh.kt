package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh

/** Triangulates [polygons] and builds a mesh from the triangles. Not thread safe. */
internal class PolygonMesh(
    private val source: Source,
    private val vertices: VertexArrays,
    private val polygons: Polygons,
) {
    /** Whether all polygons are triangles with valid vertices, so that none is triangulated or skipped. */
    private val areTriangles = polygons.areTriangles && polygons.areBelow(vertices.count)

    /** By triangle and corner: the corner's number among the corners of all polygons; empty if [areTriangles]. */
    private val corners = Ints(if (areTriangles) 0 else polygons.cornerCount)

    /** By triangle: number of its polygon; empty if [areTriangles]. */
    private val polygonOf = Ints()

    init {
        if (!areTriangles) cut()
        source.loading.triangles(source, triangleCount.toLong())
    }

    /** Number of triangles. */
    val triangleCount: Int get() = if (areTriangles) polygons.count else corners.size / 3

    /** Returns the number of a triangle's texture, or -1. */
    fun textureOf(triangle: Int): Int = polygons.textureOf(polygon(triangle))

    /**
     * Returns all triangles in the order of their polygons. Vertex colours take precedence over polygon colours, as
     * in MeshLab.
     */
    fun mesh(material: Material): Mesh {
        if (!polygons.haveAttributes) {
            val triangles =
                if (areTriangles) polygons.vertices() else IntArray(corners.size) { polygons.vertex(corners[it]) }
            return Mesh(
                vertices.positions, triangles, material, vertices.normals, vertices.uvs, vertices.colors,
                vertices.origin,
            )
        }
        val mesh = CornerMesh(vertices, polygons.colors, polygons.places)
        for (i in 0 until 3 * triangleCount) {
            val corner = if (areTriangles) i else corners[i]
            val color = if (vertices.colors == null) polygons.colorOf(polygon(i / 3)) else -1
            mesh.add(polygons.vertex(corner), color, polygons.place(corner))
        }
        return mesh.mesh(source, material)
    }

    private fun polygon(triangle: Int): Int = if (areTriangles) triangle else polygonOf[triangle]

    /** Triangulates all polygons whose vertices exist. */
    private fun cut() {
        var withoutVertices = 0
        for (polygon in 0 until polygons.count) {
            val start = polygons.start(polygon)
            val end = polygons.end(polygon)
            if (!haveVertices(start, end)) {
                withoutVertices++
            } else if (end - start == 3) {
                for (corner in start until end) corners.add(corner)
            } else {
                cut(start, end - start)
            }
            while (3 * polygonOf.size < corners.size) polygonOf.add(polygon)
        }
        if (withoutVertices > 0) {
            source.warn("$withoutVertices faces are left out, because some of their vertices are missing")
        }
    }

    private fun haveVertices(from: Int, until: Int): Boolean {
        for (corner in from until until) if (polygons.vertex(corner) >= vertices.count) return false
        return true
    }

    private fun cut(start: Int, count: Int) {
        val local = Triangulation.triangles(
            DoubleArray(3 * count) { vertices.positions[3 * polygons.vertex(start + it / 3) + it % 3].toDouble() },
        )
        if (local == null) {
            val most = Triangulation.MAX_CONCAVE_CORNERS
            source.warn("a concave face of $count corners, more than $most, is left out")
            return
        }
        for (corner in local) corners.add(start + corner)
    }
}
