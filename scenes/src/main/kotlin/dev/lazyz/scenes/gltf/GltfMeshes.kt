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
        val uvs = sets.map { vertices.floats(it, ElementType.VEC2) }
        vertices.countUnused(sets)
        val colors = vertices.floats("COLOR_0", ElementType.VEC3, ElementType.VEC4)?.let { opaque(it, count) }
        vertices.checkCount(normals, 3, count, "$here.NORMAL")
        for ((set, numbers) in sets.zip(uvs)) vertices.checkCount(numbers, 2, count, "$here.$set")
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
        val mesh = Mesh(
            positions,
            triangles(mode, indices, where),
            material.material.withMapsOf { uvs.getOrNull(it) != null },
            normals,
            uvs.getOrNull(0),
            colors,
            uvs2 = uvs.getOrNull(1),
        )
        return if (mesh.material.normalMap == null) mesh else withTangents(mesh, vertices, here)
    }

    /**
     * Returns [mesh] with its tangents. Those of the file are for its normals; without these, they are computed (section
     * 3.7.2.1).
     */
    private fun withTangents(mesh: Mesh, vertices: GltfVertices, here: String): Mesh {
        val given = if (mesh.normals == null) null else vertices.floats("TANGENT", ElementType.VEC4)
        vertices.checkCount(given, 4, mesh.vertexCount, "$here.TANGENT")
        if (given != null) {
            return Mesh(
                mesh.positions, mesh.triangles, mesh.material, mesh.normals, mesh.uvs, mesh.colors, uvs2 = mesh.uvs2,
                tangents = given,
            )
        }
        val map = checkNotNull(mesh.material.normalMap).map
        return mesh.withTangents(map.uvSet, map.transform)
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
