package dev.lazyz.scenes.gltf

import de.javagl.jgltf.impl.v2.MeshPrimitive
import de.javagl.jgltf.model.ElementType
import dev.lazyz.Lines
import dev.lazyz.Mesh
import dev.lazyz.Points
import dev.lazyz.Surface
import dev.lazyz.scenes.images.withoutTexture

/**
 * Meshes (section 3.7): each primitive becomes a [Mesh], without the texture if it has no coordinates for it, or [Points]
 * or [Lines].
 */
internal class GltfMeshes(private val document: GltfDocument) {
    private val accessors = GltfAccessors(document)
    private val materials = GltfMaterials(document)
    private val meshes = HashMap<Int, List<Surface>>()

    /** Returns what a node shows, in world space. */
    fun of(placed: PlacedNode): List<Surface> {
        val index = placed.node.mesh ?: return emptyList()
        val mesh = document.element(document.json.meshes, index, "meshes", "nodes[${placed.index}].mesh")
        val own = meshes.getOrPut(index) {
            val primitives: List<MeshPrimitive?> = mesh.primitives.orEmpty()
            primitives.indices.mapNotNull { i ->
                val where = "meshes[$index].primitives[$i]"
                primitive(document.element(primitives, i, "meshes[$index].primitives", where), where)
            }
        }
        return if (NodeTransforms.isIdentity(placed.toWorld)) own else own.map { moved(it, placed) }
    }

    /** A mesh takes memory again wherever it is placed. */
    private fun moved(surface: Surface, placed: PlacedNode): Surface = when (surface) {
        is Points -> surface.also { count(it.positions) }.transformed(placed.toWorld)
        is Lines -> surface.also { count(it.positions) }.transformed(placed.toWorld)
        else -> (surface as Mesh).also { count(it.positions) }.transformed(placed.toWorld)
    }

    private fun count(positions: FloatArray) {
        document.source.loading.vertices(document.source, positions.size / 3L)
    }

    private fun primitive(primitive: MeshPrimitive, where: String): Surface? {
        val mode = primitive.mode ?: GltfTriangles.TRIANGLES
        if (mode !in GltfPoints.POINTS..GltfTriangles.FAN) document.fail("$where.mode", "there is no mode $mode")
        val attributes: Map<String, Int?> = primitive.attributes.orEmpty()
        if (attributes["POSITION"] == null) {
            document.warn("$where: there are no positions, so nothing of it is drawn")
            return null
        }
        if (!primitive.targets.isNullOrEmpty()) document.warn("morph targets are not applied")

        val here = "$where.attributes"
        val positions = accessors.floats(attributes["POSITION"], "$here.POSITION", ElementType.VEC3)
        val count = positions.size / 3
        document.source.loading.vertices(document.source, count.toLong())
        val normals = attributes["NORMAL"]?.let { accessors.floats(it, "$here.NORMAL", ElementType.VEC3) }
        val material = materials.material(primitive.material, "$where.material")
        val set = "TEXCOORD_${material.texCoordSet}"
        val uvs = attributes[set]?.let { accessors.floats(it, "$here.$set", ElementType.VEC2) }
        val colors = attributes["COLOR_0"]?.let { colors(it, "$here.COLOR_0") }
        checkCount(normals, 3, count, "$here.NORMAL")
        checkCount(uvs, 2, count, "$here.$set")
        checkCount(colors, 4, count, "$here.COLOR_0")
        val indices = indices(primitive, count, where)
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
            if (uvs == null) material.material.withoutTexture() else material.material,
            normals,
            uvs?.let(material.transform::applyTo),
            colors,
        )
    }

    private fun colors(index: Int, where: String): FloatArray {
        val numbers = accessors.floats(index, where, ElementType.VEC3, ElementType.VEC4)
        if (accessors.type(index) == ElementType.VEC4) return numbers
        return FloatArray(numbers.size / 3 * 4) { if (it % 4 == 3) 1f else numbers[it / 4 * 3 + it % 4] }
    }

    private fun checkCount(numbers: FloatArray?, width: Int, count: Int, where: String) {
        if (numbers != null && numbers.size != width * count) {
            document.fail(where, "there are ${numbers.size / width} elements for $count positions")
        }
    }

    private fun indices(primitive: MeshPrimitive, count: Int, where: String): IntArray {
        val indices = primitive.indices?.let { accessors.indices(it, "$where.indices") } ?: IntArray(count) { it }
        for ((i, vertex) in indices.withIndex()) {
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
