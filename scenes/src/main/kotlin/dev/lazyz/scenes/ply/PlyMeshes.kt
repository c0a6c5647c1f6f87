package dev.lazyz.scenes.ply

import dev.lazyz.Material
import dev.lazyz.Mesh
import dev.lazyz.Texture
import dev.lazyz.scenes.Source
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.images.withoutTexture
import dev.lazyz.scenes.triangulation.CornerMesh
import dev.lazyz.scenes.triangulation.Ints
import dev.lazyz.scenes.triangulation.MeshParts
import dev.lazyz.scenes.triangulation.Triangulation
import dev.lazyz.scenes.triangulation.VertexArrays

/**
 * Cuts [polygons] into triangles and makes meshes of them: one, or one for each texture.
 *
 * @param textureFiles names of pictures; texture numbers count from 0
 */
internal class PlyMeshes(
    private val source: Source,
    private val vertices: VertexArrays,
    private val polygons: PlyPolygons,
    private val textureFiles: List<String>,
) {
    /** Where triangles' corners stand in the [polygons], and which polygon each triangle is of. */
    private val corners = Ints(polygons.size - polygons.size / 4)
    private val polygonOf = Ints()

    /** By polygon: where it stands. */
    private val starts = Ints()

    fun build(): List<Mesh> {
        cut()
        source.loading.triangles(source, corners.size / 3L)
        if (corners.size == 0) return emptyList()
        val whole = if (polygons.haveLooks) withLooks() else plain()
        val shaded = if (whole.normals == null) whole.withSmoothNormals(PlyParser.CREASE_ANGLE) else whole
        return if (polygons.havePlaces) textured(shaded) else listOf(shaded)
    }

    private fun plain(): Mesh {
        val triangles = IntArray(corners.size) { polygons[corners[it]] }
        val texture = if (vertices.uvs == null) null else texture(0)
        return Mesh(
            vertices.positions,
            triangles,
            Material(texture = texture),
            vertices.normals,
            vertices.uvs,
            vertices.colors,
        )
    }

    private fun withLooks(): Mesh {
        // Colours of vertices, where there are any, hide those of faces, as in MeshLab
        val mesh = CornerMesh(vertices, polygons.colors, polygons.places)
        for (i in 0 until corners.size) {
            val color = if (vertices.colors == null) polygons.colorOf(polygonOf[i / 3]) else -1
            mesh.add(polygons[corners[i]], color, polygons.place(corners[i]))
        }
        val texture = if (polygons.havePlaces || vertices.uvs == null) null else texture(0)
        return mesh.mesh(source, Material(texture = texture))
    }

    /** Returns [whole] in parts, one for each texture. */
    private fun textured(whole: Mesh): List<Mesh> {
        val groups = LinkedHashMap<Int, Int>()
        val groupOf = Ints()
        for (triangle in 0 until polygonOf.size) {
            val number = polygons.place(starts[polygonOf[triangle]]).coerceIn(-1, textureFiles.size)
            groupOf.add(groups.getOrPut(number) { groups.size })
        }
        val parts = MeshParts(whole, groupOf, groups.size)
        return groups.map { (number, group) -> parts.part(group).withTexture(texture(number)) }
    }

    private fun Mesh.withTexture(texture: Texture?) = Mesh(
        positions,
        triangles,
        if (texture == null) material.withoutTexture() else Material(texture = texture),
        normals,
        uvs,
        colors,
    )

    private fun texture(number: Int): Texture? {
        val name = textureFiles.getOrNull(number) ?: return null
        val baseName = source.name.substringAfterLast('/').substringAfterLast('\\').substringBeforeLast('.')
        return TextureFiles.find(source, name.replace("<this>", baseName))
    }

    /** Cuts all polygons whose vertices are there. */
    private fun cut() {
        var at = 0
        var withoutVertices = 0
        for (polygon in 0 until polygons.count) {
            starts.add(at)
            val count = polygons[at++]
            if ((at until at + count).any { polygons[it] >= vertices.count }) {
                withoutVertices++
            } else if (count == 3) {
                for (corner in at until at + 3) corners.add(corner)
            } else {
                cut(at, count)
            }
            while (3 * polygonOf.size < corners.size) polygonOf.add(polygon)
            at += count
        }
        if (withoutVertices >
            0
        ) {
            source.warn("$withoutVertices faces are left out, because vertices of theirs are missing")
        }
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
