package dev.lazyz.scenes.gltf

import de.javagl.jgltf.impl.v2.MeshPrimitive
import de.javagl.jgltf.model.ElementType
import dev.lazyz.world.Lines
import dev.lazyz.world.Mesh
import dev.lazyz.world.Points
import dev.lazyz.world.Surface

/**
 * Reads meshes (section 3.7). Each primitive becomes a [Mesh], [Points] or [Lines]. A mesh without texture coordinates
 * has no texture.
 */
internal class GltfMeshes(
    private val document: GltfDocument,
    private val accessors: GltfAccessors,
    private val poses: GltfPoses,
) {
    private val materials = GltfMaterials(document)
    private val meshes = HashMap<Int, List<GltfPart>>()

    /** Returns the surfaces of a node, in world space. */
    fun of(placed: PlacedNode): List<Surface> {
        val index = placed.node.mesh ?: return emptyList()
        val mesh = document.element(document.json.meshes, index, "meshes", "nodes[${placed.index}].mesh")
        val own = meshes.getOrPut(index) {
            val primitives: List<MeshPrimitive?> = mesh.primitives.orEmpty()
            primitives.indices.mapNotNull { i ->
                val where = "meshes[$index].primitives[$i]"
                val primitive = document.element(primitives, i, "meshes[$index].primitives", where)
                val vertices = GltfVertices(document, accessors, primitive, where)
                primitive(primitive, vertices, where)?.let { GltfPart(it, primitive, vertices, where) }
            }
        }
        return own.map { poses.posed(it, mesh, placed) }
    }

    private fun primitive(primitive: MeshPrimitive, vertices: GltfVertices, where: String): Surface? {
        val mode = primitive.mode ?: GltfTriangles.TRIANGLES
        if (mode !in GltfPoints.POINTS..GltfTriangles.FAN) document.fail("$where.mode", "there is no mode $mode")
        val positions = vertices.floats("POSITION", ElementType.VEC3)
        if (positions == null) {
            document.warn("$where: there are no positions, so nothing of it is drawn")
            return null
        }
        val here = "$where.attributes"
        val count = positions.size / 3
        document.source.loading.vertices(document.source, count.toLong())
        val normals = vertices.floats("NORMAL", ElementType.VEC3)
        val material = materials.material(primitive.material, "$where.material")
        val sets = material.texCoordSets.map { "TEXCOORD_$it" }
        val uvs = sets.getOrNull(0)?.let { vertices.floats(it, ElementType.VEC2) }
        vertices.countUnused(sets)
        val colors = vertices.floats("COLOR_0", ElementType.VEC3, ElementType.VEC4)?.let { opaque(it, count) }
        vertices.checkCount(normals, 3, count, "$here.NORMAL")
        vertices.checkCount(uvs, 2, count, "$here.${sets.getOrNull(0)}")
        vertices.checkCount(colors, 4, count, "$here.COLOR_0")
        val indices = indices(vertices, count, where)
        if (mode < GltfTriangles.TRIANGLES) {
            val own = if (primitive.material == null) null else material.material
            if (mode == GltfPoints.POINTS) {
                document.source.loading.vertices(document.source, indices.size.toLong())
            } else {
                document.source.loading.segments(document.source, indices.size.toLong())
            }
            return GltfPoints.of(mode, indices, positions, own, normals, colors)
        }
        return Mesh(
            positions,
            triangles(mode, indices, where),
            if (uvs == null) material.material.withoutMaps() else material.material,
            normals,
            uvs,
            colors,
        )
    }

    /** Returns RGBA colours. RGB colours get an alpha of 1. */
    private fun opaque(numbers: FloatArray, count: Int): FloatArray {
        if (numbers.size != 3 * count) return numbers
        return FloatArray(4 * count) { if (it % 4 == 3) 1f else numbers[it / 4 * 3 + it % 4] }
    }

    private fun indices(vertices: GltfVertices, count: Int, where: String): IntArray {
        val indices = vertices.indices() ?: IntArray(count) { it }
        for (i in indices.indices) {
            val vertex = indices[i]
            if (vertex !in 0 until count) {
                val shown = if (vertex < 0) "beyond 31 bits" else vertex.toString()
                document.fail("$where.indices", "element $i is $shown, but there are $count vertices, counted from 0")
            }
        }
        return indices
    }

    private fun triangles(mode: Int, indices: IntArray, where: String): IntArray {
        if (mode == GltfTriangles.TRIANGLES && indices.size % 3 != 0) {
            document.warn("$where: vertex numbers are not triples; the last ${indices.size % 3} are left out")
        }
        val triangles = if (mode == GltfTriangles.TRIANGLES) indices.size / 3 else maxOf(indices.size - 2, 0)
        document.source.loading.triangles(document.source, triangles.toLong())
        return GltfTriangles.of(mode, indices)
    }
}
