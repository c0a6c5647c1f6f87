package dev.lazyz.scenes.obj

import dev.lazyz.Mesh
import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.Ints
import dev.lazyz.scenes.triangulation.Triangulation

/**
 * Makes meshes of faces: for each object, in the order of the file, one for each material and kind of normals, in the
 * order of their first face, with its faces in the order of the file.
 *
 * Faces of one object that have no normals are made smooth together, so that a change of material is no crease.
 */
internal class ObjMeshes(
    private val source: Source,
    private val model: ObjCollector,
    private val materialOf: (String?) -> MtlMaterial,
) {
    private enum class Normals { GIVEN, SMOOTH, FLAT }

    private data class Group(val material: String?, val isTextured: Boolean)

    private class Placed(val firstFace: Int, val mesh: Mesh)

    private val faces = model.faces
    private val positions = model.positions.toArray()
    private val textures = model.textures.toArray()
    private val normals = model.normals.toArray()
    private val vertices = CornerVertices(positions.size / 3)

    fun build(): List<Mesh> {
        val byObject = (0 until faces.size).groupBy { faces.part(it).objectNumber }
        return byObject.values.flatMap { ofObject ->
            val byNormals = ofObject.groupBy(::normals)
            byNormals.flatMap { (kind, some) -> meshes(kind, some) }.sortedBy { it.firstFace }.map { it.mesh }
        }
    }

    private fun normals(face: Int): Normals = when {
        faces.normals[faces.corners(face).first] >= 0 -> Normals.GIVEN
        faces.part(face).isSmooth -> Normals.SMOOTH
        else -> Normals.FLAT
    }

    private fun group(face: Int) = Group(faces.part(face).material, faces.textures[faces.corners(face).first] >= 0)

    private fun meshes(kind: Normals, some: List<Int>): List<Placed> {
        // Cut all faces into triangles, and remember which group each triangle belongs to
        vertices.clear()
        val groups = LinkedHashMap<Group, Int>()
        val firstFaces = ArrayList<Int>()
        val triangles = Ints()
        val groupOf = Ints()
        for (face in some) {
            val group = groups.getOrPut(group(face)) {
                firstFaces.add(face)
                groups.size
            }
            addTriangles(face, triangles)
            while (3 * groupOf.size < triangles.size) groupOf.add(group)
        }

        // Normals first, then the groups, for normals do not end where a material does
        val whole = Mesh(
            gather(vertices.positions, positions, 3),
            triangles.toArray(),
            normals = if (kind == Normals.GIVEN) gather(vertices.normals, normals, 3) else null,
            uvs = if (textures.isEmpty()) null else gather(vertices.textures, textures, 2),
            colors = colors(),
        )
        val shaded = if (kind == Normals.SMOOTH) whole.withSmoothNormals(ObjParser.CREASE_ANGLE) else whole
        val parts = MeshParts(shaded, groupOf, groups.size)
        return groups.map { (group, number) ->
            Placed(firstFaces[number], parts.mesh(number, materialOf(group.material), group.isTextured))
        }
    }

    private fun addTriangles(face: Int, triangles: Ints) {
        val corners = faces.corners(face)
        val count = corners.last - corners.first + 1
        val local = Triangulation.triangles(
            DoubleArray(3 * count) { positions[3 * faces.positions[corners.first + it / 3] + it % 3].toDouble() },
        )
        if (local == null) {
            val most = Triangulation.MAX_CONCAVE_CORNERS
            source.warn("line ${faces.line(face)}: a concave face of $count corners, more than $most, is left out")
            return
        }
        for (number in local) {
            val corner = corners.first + number
            triangles.add(vertices.vertex(faces.positions[corner], faces.textures[corner], faces.normals[corner]))
        }
    }

    private fun colors(): FloatArray? {
        if (model.colors.size == 0) return null
        return FloatArray(4 * vertices.positions.size) {
            val at = 3 * vertices.positions[it / 4] + it % 4
            if (it % 4 < 3 && at < model.colors.size) model.colors[at] else 1f
        }
    }

    /** Gives each vertex its [width] numbers out of [from]; 0 where it has none. */
    private fun gather(numbers: Ints, from: FloatArray, width: Int): FloatArray = FloatArray(width * numbers.size) {
        val number = numbers[it / width]
        if (number < 0) 0f else from[width * number + it % width]
    }
}
