package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.scenes.gltf.document.ElementType
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.MeshJson
import dev.lazyz.scenes.gltf.document.PrimitiveJson
import dev.lazyz.scenes.gltf.materials.GltfMaterials
import dev.lazyz.scenes.loading.PartNames
import dev.lazyz.scenes.meshes.MissingNormals
import dev.lazyz.scenes.meshes.PixelDefaults
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface

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
    private val instances = GltfInstances(document, accessors)
    private val meshes = HashMap<Int, List<GltfPart>>()

    /** The number of the variant that was asked for, or null. */
    private val variant: Int? by lazy(LazyThreadSafetyMode.NONE) {
        document.source.loading.options.variant?.let(::variant)
    }

    /** Returns the surfaces of a node, in world space: those of its mesh, once for each instance. */
    fun of(placed: PlacedNode): List<Surface> {
        document.source.step()
        val index = placed.node.mesh ?: return emptyList()
        val mesh = document.element(document.json.meshes, index, "meshes", "nodes[${placed.index}].mesh")
        val own = meshes.getOrPut(index) {
            mesh.primitives.indices.mapNotNull { i ->
                val where = "meshes[$index].primitives[$i]"
                val primitive = document.element(mesh.primitives, i, "meshes[$index].primitives", where)
                val vertices = GltfVertices(document, accessors, primitive, where)
                primitive(primitive, vertices, where)?.let { GltfPart(it, primitive, vertices, where) }
            }
        }
        val shown = instances.of(placed)
        for (part in own) repeated(part.surface, shown.size - 1L)
        val name = name(placed, mesh)
        return shown.flatMap { instance ->
            own.map { named(withTangents(withNormals(poses.posed(it, mesh, instance))), name) }
        }
    }

    /** Returns the path of a node; a node without a name has that of its [mesh]. */
    private fun name(placed: PlacedNode, mesh: MeshJson): String =
        if (placed.node.name.isNullOrBlank()) PartNames.path(placed.path, mesh.name) else placed.path

    private fun named(surface: Surface, name: String): Surface = if (name.isEmpty()) surface else surface.withName(name)

    /** Counts [more] copies of [surface] with its triangles or lines; [GltfPoses] counts the vertices. */
    private fun repeated(surface: Surface, more: Long) {
        if (more <= 0) return
        val source = document.source
        source.loading.decode(source, more * SURFACE_BYTES)
        if (surface is Mesh) source.loading.triangles(source, more * surface.triangleCount)
        if (surface is Lines) source.loading.segments(source, more * surface.segmentCount)
    }

    private fun primitive(primitive: PrimitiveJson, vertices: GltfVertices, where: String): Surface? {
        val mode = primitive.mode ?: GltfTriangles.TRIANGLES
        val positions = vertices.floats("POSITION", ElementType.VEC3)
        if (positions == null) {
            document.warn(where, ": there are no positions, so nothing of it is drawn")
            return null
        }
        val here = "$where.attributes"
        val count = positions.size / 3
        document.source.loading.vertices(document.source, count.toLong())
        val normals = vertices.floats("NORMAL", ElementType.VEC3)
        val number = material(primitive)
        val material = materials.material(number, "$where.material")
        val sets = material.texCoordSets.map { "TEXCOORD_$it" }
        val uvs = sets.map { vertices.floats(it, ElementType.VEC2) }
        vertices.countUnused(sets)
        val colors = vertices.colors(count)
        vertices.checkCount(normals, 3, count, "$here.NORMAL")
        for ((set, numbers) in sets.zip(uvs)) vertices.checkCount(numbers, 2, count, "$here.$set")
        val indices = indices(vertices, count, where)
        if (mode < GltfTriangles.TRIANGLES) {
            val own = if (number == null) null else material.material
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
            material.material.withMapsOf { uvs.getOrNull(it) != null },
            normals,
            uvs.getOrNull(0),
            colors,
            uvs2 = uvs.getOrNull(1),
            tangents = if (normals == null || !material.material.usesTangents) {
                null
            } else {
                tangents(vertices, count, here)
            },
        )
    }

    private fun variant(name: String): Int {
        val names = document.json.variants
        val number = names.indexOf(name)
        if (number < 0) {
            val known = names.take(MOST_SHOWN).joinToString { "\"$it\"" }
            val remedy = if (names.isEmpty()) "choose none" else "choose one of $known"
            document.source.fail(null, "there is no variant \"$name\"", remedy)
        }
        return number
    }

    /** Returns the number of the material of [primitive], in the variant that was asked for. */
    private fun material(primitive: PrimitiveJson): Int? {
        val wanted = variant ?: return primitive.material
        return primitive.variants.firstOrNull { it != null && wanted in it.variants }?.material ?: primitive.material
    }

    private fun tangents(vertices: GltfVertices, count: Int, here: String): FloatArray? {
        val tangents = vertices.floats("TANGENT", ElementType.VEC4)
        vertices.checkCount(tangents, 4, count, "$here.TANGENT")
        return tangents
    }

    /** Returns [surface] with the normals of its triangles where the file gives normals without a direction. */
    private fun withNormals(surface: Surface): Surface {
        if (surface !is Mesh || surface.normals == null) return surface
        return MissingNormals.computed(document.source, surface, creaseAngle = 0.0) { true }
    }

    /**
     * Returns [surface] with the tangents that its material needs. If the file has none, or has no normals that they
     * would belong to (section 3.7.2.1), they are computed now, because this may split vertices.
     */
    private fun withTangents(surface: Surface): Surface = if (surface is Mesh) surface.withNeededTangents() else surface

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
            document.warn(where, ": vertex numbers are not triples; the last ${indices.size % 3} are left out")
        }
        val triangles = if (mode == GltfTriangles.TRIANGLES) indices.size / 3 else maxOf(indices.size - 2, 0)
        document.source.loading.triangles(document.source, triangles.toLong())
        return GltfTriangles.of(mode, indices)
    }

    private companion object {
        /** Memory for the objects of a surface without its numbers. */
        const val SURFACE_BYTES = 512L

        /** Names of variants in a message. */
        const val MOST_SHOWN = 20
    }
}

/** Points, and the three modes that join vertices to lines (section 3.7.2.1). */
internal object GltfPoints {
    const val POINTS = 0
    private const val LINES = 1
    private const val LOOP = 2

    /**
     * Returns the points or lines that the vertex numbers [indices] describe. An incomplete last line segment is
     * dropped.
     *
     * @param material null if the file gives none
     */
    fun of(
        mode: Int,
        indices: IntArray,
        positions: FloatArray,
        material: Material?,
        normals: FloatArray?,
        colors: FloatArray?,
    ): Surface {
        val own = if (mode == POINTS) MissingNormals.ofPoints(normals) else null
        val paint = material ?: PixelDefaults.material(own != null, colors != null)
        if (mode != POINTS) return Lines(positions, segments(mode, indices), PixelDefaults.LINE_WIDTH, paint, colors)
        return Points(
            gather(positions, indices, 3),
            PixelDefaults.POINT_SIZE,
            paint,
            own?.let { gather(it, indices, 3) },
            colors?.let { gather(it, indices, 4) },
        )
    }

    /** Returns vertex numbers, two for each segment. */
    fun segments(mode: Int, indices: IntArray): IntArray {
        if (mode == LINES) return indices.copyOf(indices.size / 2 * 2)
        val isClosed = mode == LOOP && indices.size > 1
        val count = maxOf(indices.size - 1, 0) + (if (isClosed) 1 else 0)
        return IntArray(2 * count) { indices[(it / 2 + it % 2) % indices.size] }
    }

    private fun gather(numbers: FloatArray, indices: IntArray, width: Int): FloatArray =
        FloatArray(width * indices.size) { numbers[width * indices[it / width] + it % width] }
}

/** The three modes that join vertices to triangles (section 3.7.2.1). */
internal object GltfTriangles {
    const val TRIANGLES = 4
    const val STRIP = 5
    const val FAN = 6

    /**
     * Returns vertex numbers, three for each triangle. All triangles have the same winding as the first. Vertices of an
     * incomplete last triangle are dropped.
     */
    fun of(mode: Int, indices: IntArray): IntArray {
        if (mode == TRIANGLES) return if (indices.size % 3 == 0) indices else indices.copyOf(indices.size / 3 * 3)
        val triangles = IntArray(3 * maxOf(indices.size - 2, 0))
        for (i in 0 until triangles.size / 3) {
            val isOdd = i % 2
            triangles[3 * i] = indices[if (mode == FAN) i + 1 else i]
            triangles[3 * i + 1] = indices[if (mode == FAN) i + 2 else i + 1 + isOdd]
            triangles[3 * i + 2] = indices[if (mode == FAN) 0 else i + 2 - isOdd]
        }
        return triangles
    }
}
