package dev.lazyz.scenes.obj

import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.MeshParts
import dev.lazyz.scenes.meshes.MissingNormals
import dev.lazyz.scenes.meshes.Triangulation
import dev.lazyz.scenes.meshes.VertexPositions
import dev.lazyz.scenes.obj.materials.MtlMaterial
import dev.lazyz.world.surface.Mesh
import java.util.BitSet

/**
 * Builds meshes from faces. Each object, in the order of the file, becomes one mesh for each group, material
 * and kind of normals. Meshes are in the order of their first face, and faces in the order of the file.
 *
 * Normals of faces without any are computed for each object as a whole, so a change of group or material does not
 * make a crease; see also [MissingNormals].
 */
internal class ObjMeshes(
    private val source: Source,
    private val model: ObjModel,
    private val materialOf: (String?) -> MtlMaterial,
) {
    private enum class Normals { GIVEN, SMOOTH, FLAT }

    /** Faces of one object with one kind of normals. */
    private class Batch(val normals: Normals) {
        val faces = Ints()
    }

    private data class Group(val label: Label, val isTextured: Boolean)

    private class Placed(val firstFace: Int, val mesh: Mesh)

    private val faces = model.faces
    private val positions = model.positions.toArray()
    private val textures = model.textures.toArray()
    private val normals = model.normals.toArray()
    private val cutting = FaceCutting(source, faces) { vertex, axis -> positions[3 * vertex + axis] }
    private val corners = Ints()
    private val vertices = CornerVertices(positions.size / 3)

    fun build(): List<Mesh> = batchesByObject().flatMap { batches ->
        batches.flatMap(::meshes).sortedBy { it.firstFace }.map { it.mesh }
    }

    private fun batchesByObject(): List<Collection<Batch>> {
        val objects = LinkedHashMap<Int, LinkedHashMap<Normals, Batch>>()

        // Faces of one part that all have normals, or all have none, belong to one batch; look it up only once
        val batchOf = arrayOfNulls<Batch>(2 * faces.parts.size)
        for (face in 0 until faces.size) {
            source.step()
            val hasNormals = faces.normals[faces.start(face)] >= 0
            val key = 2 * faces.part(face) + (if (hasNormals) 1 else 0)
            val batch = batchOf[key] ?: run {
                val part = faces.parts[faces.part(face)]
                val kind = if (hasNormals) Normals.GIVEN else without(part)
                objects.getOrPut(part.objectNumber) { LinkedHashMap() }.getOrPut(kind) { Batch(kind) }
            }
            batchOf[key] = batch
            batch.faces.add(face)
        }
        return objects.values.map { it.values }
    }

    private fun without(part: Part): Normals = if (part.isSmooth) Normals.SMOOTH else Normals.FLAT

    private fun meshes(batch: Batch): List<Placed> {
        // Triangulate all faces, and record the group of each triangle
        vertices.begin()
        val groups = LinkedHashMap<Group, Int>()
        val firstFaces = ArrayList<Int>()
        val triangles = Ints()
        val groupOf = Ints()
        val flat = BitSet()
        var lastPart = -1
        var isTextured = false
        var group = -1
        for (i in 0 until batch.faces.size) {
            val face = batch.faces[i]
            val hasTextures = faces.textures[faces.start(face)] >= 0
            if (faces.part(face) != lastPart || hasTextures != isTextured) {
                lastPart = faces.part(face)
                isTextured = hasTextures
                group = groups.getOrPut(Group(faces.parts[lastPart].label, hasTextures)) {
                    firstFaces.add(face)
                    groups.size
                }
            }
            addTriangles(face, triangles)
            if (!faces.parts[lastPart].isSmooth) flat.set(groupOf.size, triangles.size / 3)
            while (3 * groupOf.size < triangles.size) groupOf.add(group)
        }

        // Compute the normals before dividing into groups, because smooth surfaces continue across materials
        val whole = Mesh(
            vertices.positions(positions),
            triangles.toArray(),
            normals = if (batch.normals == Normals.GIVEN) vertices.normals(normals) else null,
            uvs = if (textures.isEmpty()) null else vertices.textures(textures),
            colors = model.colors(vertices.size, vertices::position),
            origin = model.origin,
        )
        val isFlat = batch.normals == Normals.FLAT
        val shaded = if (isFlat) whole else MissingNormals.computed(source, whole, ObjParser.CREASE_ANGLE, flat::get)
        val parts = MeshParts(source, shaded, groupOf, groups.size)
        return groups.map { (group, number) ->
            Placed(firstFaces[number], finished(parts.part(number), group))
        }
    }

    /**
     * Returns [part] with the name and the material of its [group]. Texture coordinates, whose v points upward so far,
     * are scaled and offset as the material specifies, and v is flipped to point downward. If the group has none,
     * coordinates and maps are removed. A normal map gets its tangents.
     */
    private fun finished(part: Mesh, group: Group): Mesh {
        val material = materialOf(group.label.material)
        val mesh = Mesh(
            part.positions,
            part.triangles,
            if (group.isTextured) material.material else material.material.withoutMaps(),
            part.normals,
            if (group.isTextured) part.uvs?.also { place(it, material) } else null,
            part.colors,
            part.origin,
            name = group.label.name,
        )
        return mesh.withNeededTangents()
    }

    private fun place(uvs: FloatArray, material: MtlMaterial) {
        for (i in uvs.indices step 2) {
            uvs[i] = (uvs[i] * material.scaleU + material.offsetU).toFloat()
            uvs[i + 1] = (1.0 - (uvs[i + 1] * material.scaleV + material.offsetV)).toFloat()
        }
    }

    private fun addTriangles(face: Int, triangles: Ints) {
        corners.clear()
        cutting.cut(face, corners)
        for (i in 0 until corners.size) triangles.add(vertex(corners[i]))
    }

    private fun vertex(corner: Int): Int =
        vertices.vertex(faces.positions[corner], faces.textures[corner], faces.normals[corner])
}

/**
 * Merges equal corners of the faces of a mesh: corners with the same position, texture coordinate and normal become one
 * vertex. Serves one mesh after the other. Not thread safe.
 *
 * Most corners are equal to the first one at their position, so these are found without hashing.
 *
 * @param positionCount number of positions of all meshes
 */
internal class CornerVertices(positionCount: Int) {
    /** The position, texture coordinate and normal of each vertex. */
    private val corners = Ints()

    /** By position: the number of its first vertex plus 1, counted from the first mesh on; 0 if there is none. */
    private val firstAt = IntArray(positionCount)

    /** Vertices of all meshes before this one. */
    private var before = 0

    /** Corners that differ from the first one at their position, and their vertices. */
    private var others = DistinctTriples()
    private val otherVertices = Ints()

    /** Number of vertices of this mesh. */
    val size: Int get() = corners.size / 3

    /** Begins a mesh, which shares no vertices with those before. */
    fun begin() {
        before += size
        corners.clear()
        otherVertices.clear()
        others = DistinctTriples()
    }

    /**
     * Returns the number of the vertex for a corner. Adds a vertex if there is none yet. -1 stands for a missing
     * texture coordinate or normal.
     */
    fun vertex(position: Int, texture: Int, normal: Int): Int {
        val first = firstAt[position] - 1 - before
        if (first < 0) {
            firstAt[position] = before + size + 1
            return append(position, texture, normal)
        }
        if (corners[3 * first + 1] == texture && corners[3 * first + 2] == normal) return first
        val other = others.add(position, texture, normal)
        if (other == otherVertices.size) otherVertices.add(append(position, texture, normal))
        return otherVertices[other]
    }

    private fun append(position: Int, texture: Int, normal: Int): Int {
        corners.add(position, texture, normal)
        return size - 1
    }

    fun position(vertex: Int): Int = corners[3 * vertex]

    /** Returns x, y, z of each vertex, given those of all positions. */
    fun positions(from: FloatArray): FloatArray = gather(from, 0, 3)

    /** Returns u, v of each vertex, given those of all texture coordinates. They are 0 for a vertex without any. */
    fun textures(from: FloatArray): FloatArray = gather(from, 1, 2)

    /** Returns x, y, z of each vertex's normal, given those of all normals. They are 0 for a vertex without one. */
    fun normals(from: FloatArray): FloatArray = gather(from, 2, 3)

    private fun gather(from: FloatArray, place: Int, width: Int): FloatArray {
        val result = FloatArray(width * size)
        for (vertex in 0 until size) {
            val number = corners[3 * vertex + place]
            if (number >= 0) from.copyInto(result, width * vertex, width * number, width * (number + 1))
        }
        return result
    }
}

/** Triangulates [faces]. Not thread safe. */
internal class FaceCutting(
    private val source: Source,
    private val faces: FaceTable,
    private val positions: VertexPositions,
) {
    /** Adds the corners of the triangles of [face] to [corners], as numbers among the corners of all faces. */
    fun cut(face: Int, corners: Ints) {
        val start = faces.start(face)
        val count = faces.end(face) - start
        source.step(count)
        if (count == 3) {
            corners.add(start, start + 1, start + 2)
            return
        }
        val isSmall = count <= Triangulation.MAX_CORNERS
        val local = if (isSmall) Triangulation.triangles(xyz(start, count), source::step) else null
        if (local == null) {
            val what = "line ${faces.line(face)}: a face of $count corners"
            source.warn("", what, ", ${Triangulation.TOO_MANY}, is left out")
            return
        }
        for (corner in local) corners.add(start + corner)
    }

    private fun xyz(start: Int, count: Int): DoubleArray =
        DoubleArray(3 * count) { positions.get(faces.positions[start + it / 3], it % 3).toDouble() }
}
