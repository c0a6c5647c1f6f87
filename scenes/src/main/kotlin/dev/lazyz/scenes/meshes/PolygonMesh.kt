package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Material
import dev.lazyz.world.Mesh

/** Cuts [polygons] into triangles, and makes a mesh of them. Not thread safe. */
internal class PolygonMesh(
    private val source: Source,
    private val vertices: VertexArrays,
    private val polygons: Polygons,
) {
    /** By triangle and corner: where it stands in the [polygons]. */
    private val corners = Ints(polygons.size - polygons.size / 4)

    /** By triangle: its polygon. */
    private val polygonOf = Ints()

    /** By polygon: where it stands. */
    private val starts = Ints()

    init {
        cut()
        source.loading.triangles(source, triangleCount.toLong())
    }

    /** How many triangles there are. */
    val triangleCount: Int get() = corners.size / 3

    /** Returns the number of a triangle's texture, or -1. */
    fun textureOf(triangle: Int): Int = polygons.place(starts[polygonOf[triangle]])

    /** Returns all triangles in the order of their polygons. Colours of vertices hide those of polygons, as in MeshLab. */
    fun mesh(material: Material): Mesh {
        if (!polygons.haveLooks) {
            val triangles = IntArray(corners.size) { polygons[corners[it]] }
            return Mesh(vertices.positions, triangles, material, vertices.normals, vertices.uvs, vertices.colors)
        }
        val mesh = CornerMesh(vertices, polygons.colors, polygons.places)
        for (i in 0 until corners.size) {
            val color = if (vertices.colors == null) polygons.colorOf(polygonOf[i / 3]) else -1
            mesh.add(polygons[corners[i]], color, polygons.place(corners[i]))
        }
        return mesh.mesh(source, material)
    }

    /** Cuts all polygons whose vertices are there. */
    private fun cut() {
        var at = 0
        var withoutVertices = 0
        for (polygon in 0 until polygons.count) {
            starts.add(at)
            val count = polygons[at++]
            if (!haveVertices(at, count)) {
                withoutVertices++
            } else if (count == 3) {
                for (corner in at until at + 3) corners.add(corner)
            } else {
                cut(at, count)
            }
            while (3 * polygonOf.size < corners.size) polygonOf.add(polygon)
            at += count
        }
        if (withoutVertices > 0) {
            source.warn("$withoutVertices faces are left out, because vertices of theirs are missing")
        }
    }

    private fun haveVertices(at: Int, count: Int): Boolean {
        for (corner in at until at + count) if (polygons[corner] >= vertices.count) return false
        return true
    }

    private fun cut(at: Int, count: Int) {
        val local = Triangulation.triangles(
            DoubleArray(3 * count) { vertices.positions[3 * polygons[at + it / 3] + it % 3].toDouble() },
        )
        if (local == null) {
            val most = Triangulation.MAX_CONCAVE_CORNERS
            source.warn("a concave face of $count corners, more than $most, is left out")
            return
        }
        for (corner in local) corners.add(at + corner)
    }
}
