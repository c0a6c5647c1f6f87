package dev.lazyz.scenes.ply

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.MeshParts
import dev.lazyz.scenes.meshes.MissingNormals
import dev.lazyz.scenes.meshes.PolygonMesh
import dev.lazyz.scenes.meshes.Polygons
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import dev.lazyz.world.surface.Mesh

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
