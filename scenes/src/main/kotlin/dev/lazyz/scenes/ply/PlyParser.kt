package dev.lazyz.scenes.ply

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.MeshParts
import dev.lazyz.scenes.meshes.MissingNormals
import dev.lazyz.scenes.meshes.PolygonMesh
import dev.lazyz.scenes.meshes.Polygons
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import dev.lazyz.world.surface.Mesh

/**
 * Reads the Polygon File Format (Greg Turk, "The PLY Polygon File Format", Stanford University, 1994) in its ASCII form
 * and both binary forms.
 *
 * The file becomes meshes (one, or one for each texture) and lines, or points if it has no faces and no edges.
 *
 * - Properties of vertices: x, y, z; nx, ny, nz; s, t or u, v (upward; v is converted to `1 - v`); red, green, blue and
 *   alpha. Colours are sRGB-encoded: integers in the range of their type, or fractions in 0..1.
 * - Properties of faces, which can have any number of corners: colours, used if vertices have none, and `texcoord`, two
 *   numbers for each corner, with `texnumber`. The element `tristrips` is also read.
 * - The element `edge` gives lines between `vertex1` and `vertex2`.
 * - Comments `TextureFile` name the textures; `<this>` stands for the file's own name.
 *
 * Alpha is stored unchanged in the vertex colours, and the material stays opaque. Other elements and properties are
 * ignored with a warning. If the file has no normals, they are computed, smooth up to creases of [CREASE_ANGLE]
 * degrees. If the file is truncated, the part that is present is shown.
 */
internal object PlyParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        source.decodeText()
        val header = PlyHeaderReader(source).read()
        val tables = FarOrigin.reading(
            source.loading,
            read = { origin -> PlyTables(source, header, origin).also { it.read() } },
            bounds = { Box.around(it.vertices.positions) },
        )
        tables.warn()
        source.release()
        return scene(source, header, tables)
    }

    private fun scene(source: Source, header: PlyHeader, tables: PlyTables): Scene {
        val vertices = tables.vertices
        val meshes = PlyMeshes(source, vertices, tables.faces.polygons, header.textureFiles).build()
        val lines = if (tables.edges.isEmpty) emptyList() else listOf(tables.edges.lines(vertices))
        if (vertices.count == 0) source.warn("there are no vertices, so there is nothing to see")
        return Scene((meshes + lines).ifEmpty { vertices.points() })
    }
}

/**
 * Builds meshes from [polygons]: one, or one for each texture.
 *
 * @param textureFiles names of texture files; texture numbers count from 0
 */
internal class PlyMeshes(
    private val source: Source,
    private val vertices: VertexArrays,
    private val polygons: Polygons,
    private val textureFiles: List<String>,
) {
    fun build(): List<Mesh> {
        val triangles = PolygonMesh(source, vertices, polygons)
        if (triangles.triangleCount == 0) return emptyList()
        val hasOneTexture = vertices.uvs != null && !polygons.havePlaces
        val whole = triangles.mesh(Material(texture = if (hasOneTexture) texture(0) else null))
        val shaded = MissingNormals.computed(source, whole, PlyParser.CREASE_ANGLE)
        return if (polygons.havePlaces) textured(shaded, triangles) else listOf(shaded)
    }

    /** Divides [whole] into one mesh for each texture. */
    private fun textured(whole: Mesh, triangles: PolygonMesh): List<Mesh> {
        val groups = LinkedHashMap<Int, Int>()
        val groupOf = Ints()
        for (triangle in 0 until triangles.triangleCount) {
            source.step()
            val number = triangles.textureOf(triangle).coerceIn(-1, textureFiles.size)
            groupOf.add(groups.getOrPut(number) { groups.size })
        }
        val parts = MeshParts(source, whole, groupOf, groups.size)
        return groups.map { (number, group) ->
            val material = Material(texture = texture(number))
            parts.part(group).withMaterials { material }
        }
    }

    private fun texture(number: Int): Texture? {
        val name = textureFiles.getOrNull(number) ?: return null
        val baseName = source.name.substringAfterLast('/').substringAfterLast('\\').substringBeforeLast('.')
        return TextureFiles.find(source, name.replace("<this>", baseName))
    }
}
