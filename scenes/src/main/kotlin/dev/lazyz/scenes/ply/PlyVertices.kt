package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import org.joml.Vector3dc

/** Reads the element `vertex`, with positions relative to [origin]. */
internal class PlyVertices(
    private val source: Source,
    private val element: PlyElement,
    private val origin: Vector3dc,
) {
    private val position = listOf("x", "y", "z").map { name ->
        element.column(listOf(name)) ?: source.fail("header", "element vertex has no property $name", "add it")
    }.toIntArray()
    private val normal = columns(listOf("nx", "ny", "nz"))
    private val texture = texturePairs.firstNotNullOfOrNull(::columns)
    private val color = PlyColor.of(element)

    /** The numbers of the columns that are read. */
    val columns: Set<Int> =
        setOf(position, normal, texture).filterNotNull().flatMap { it.toList() }.toSet() +
            (color?.columns ?: emptyList())

    /** Reads all rows that are there. */
    fun read(body: PlyBody): VertexArrays {
        val room = body.room(element)
        source.loading.vertices(source, room.toLong())
        val vertices = VertexArrays(
            FloatArray(3 * room),
            normal?.let { FloatArray(3 * room) },
            texture?.let { FloatArray(2 * room) },
            color?.let { FloatArray(4 * room) },
            origin,
        )
        val count = body.readRows(element) { i, row ->
            set(vertices, i, row)
            if (color != null && vertices.colors != null) {
                for (channel in 0 until 4) vertices.colors[4 * i + channel] = color.channel(row, channel)
            }
        }
        return vertices.first(count)
    }

    private fun set(to: VertexArrays, vertex: Int, row: PlyRow) {
        for (axis in 0 until 3) {
            to.positions[3 * vertex + axis] = (row.numbers[position[axis]] - origin.get(axis)).toFloat()
        }
        if (to.normals != null && normal != null) {
            for (axis in 0 until 3) to.normals[3 * vertex + axis] = row.numbers[normal[axis]].toFloat()
        }
        if (to.uvs != null && texture != null) {
            to.uvs[2 * vertex] = row.numbers[texture[0]].toFloat()
            to.uvs[2 * vertex + 1] = (1.0 - row.numbers[texture[1]]).toFloat()
        }
    }

    /** Returns the numbers of the columns with all of [names], or null. */
    private fun columns(names: List<String>): IntArray? =
        names.mapNotNull { element.column(listOf(it)) }.takeIf { it.size == names.size }?.toIntArray()

    private companion object {
        val texturePairs = listOf("s", "t", "u", "v", "texture_u", "texture_v", "texture_s", "texture_t").chunked(2)
    }
}
