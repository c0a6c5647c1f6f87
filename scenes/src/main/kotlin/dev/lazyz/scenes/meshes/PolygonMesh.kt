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
            source.step()
            val corner = if (areTriangles) i else corners[i]
            val color = if (vertices.colors == null) polygons.colorOf(polygon(i / 3)) else -1
            mesh.add(polygons.vertex(corner), color, polygons.place(corner))
        }
        return mesh.mesh(source, material)
    }

    private fun polygon(triangle: Int): Int = if (areTriangles) triangle else polygonOf[triangle]

    private fun cut() {
        val cutting = PolygonCutting(source, vertices.count) { vertex, axis -> vertices.positions[3 * vertex + axis] }
        for (polygon in 0 until polygons.count) {
            cutting.cut(polygons, polygon, corners)
            while (3 * polygonOf.size < corners.size) polygonOf.add(polygon)
        }
        cutting.warn()
    }
}
