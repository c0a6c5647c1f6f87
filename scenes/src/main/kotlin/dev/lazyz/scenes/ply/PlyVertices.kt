package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.scenes.streaming.IndexedSpool
import org.joml.Vector3d
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
    private val colorColumns = color?.columns.orEmpty().toIntArray()
    private val isFar = origin != Vector3d()

    /** The numbers of the columns that are used. */
    val columns: Set<Int> =
        setOf(position, normal, texture).filterNotNull().flatMap { it.toList() }.toSet() +
            (color?.columns ?: emptyList())

    /** Reads all rows that are present. */
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
        return vertices.first(rows(body, vertices, -1) {})
    }

    /** The numbers of the columns that [stream] uses. */
    val streamedColumns: Set<Int> = position.toSet() + (color?.columns ?: emptyList())

    /** Adds positions and colours of all rows that are present to [spool]. */
    fun stream(body: PlyBody, spool: IndexedSpool) {
        val block = VertexArrays(FloatArray(3 * BLOCK), colors = color?.let { FloatArray(4 * BLOCK) }, origin = origin)
        val count = rows(body, block, BLOCK - 1) { spool.vertices(block, BLOCK) }
        spool.vertices(block, count and BLOCK - 1)
    }

    /**
     * Reads all rows that are present to [to], at their numbers and [mask], and calls [full] after those whose place is
     * [mask]. Returns the number of rows.
     */
    private inline fun rows(body: PlyBody, to: VertexArrays, mask: Int, full: () -> Unit): Int =
        if (body is PlyBinaryBody && areFloats()) {
            floats(body, to, mask, full)
        } else {
            body.readRows(element) { i, row ->
                val place = i and mask
                set(to, place, row)
                setColor(to, place, row)
                if (place == mask) full()
            }
        }

    /** Whether all columns in use are floats, and bytes for colours. */
    private fun areFloats(): Boolean {
        val floats = listOfNotNull(position, normal, texture).flatMap { it.toList() }
        return !element.hasLists && floats.all { element.properties[it].type == PlyType.FLOAT } &&
            color?.columns.orEmpty().all { element.properties[it].type == PlyType.UCHAR }
    }

    /** A fast path that reads all rows directly from the bytes. Returns the number of rows that are present. */
    private inline fun floats(body: PlyBinaryBody, to: VertexArrays, mask: Int, full: () -> Unit): Int {
        val places = element.properties.runningFold(0) { place, property -> place + property.type.size }.toIntArray()
        val positionPlaces = IntArray(3) { places[position[it]] }
        val row = PlyRow(element)
        return body.eachRow(element) { number, at ->
            val vertex = number and mask
            for (axis in 0 until 3) {
                val number = body.float(at + positionPlaces[axis])
                to.positions[3 * vertex + axis] = if (isFar) (number - origin.get(axis)).toFloat() else number
            }
            if (to.normals != null && normal != null) {
                for (axis in 0 until 3) to.normals[3 * vertex + axis] = body.float(at + places[normal[axis]])
            }
            if (to.uvs != null && texture != null) {
                to.uvs[2 * vertex] = body.float(at + places[texture[0]])
                to.uvs[2 * vertex + 1] = (1.0 - body.float(at + places[texture[1]])).toFloat()
            }
            if (color != null) {
                for (column in colorColumns) row.numbers[column] = body.code(at + places[column]).toDouble()
                setColor(to, vertex, row)
            }
            if (vertex == mask) full()
        }
    }

    private fun setColor(to: VertexArrays, vertex: Int, row: PlyRow) {
        if (color == null || to.colors == null) return
        for (channel in 0 until 4) to.colors[4 * vertex + channel] = color.channel(row, channel)
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

    /** Returns the numbers of the columns called [names], or null unless all of them exist. */
    private fun columns(names: List<String>): IntArray? =
        names.mapNotNull { element.column(listOf(it)) }.takeIf { it.size == names.size }?.toIntArray()

    private companion object {
        /** Vertices that are spooled at a time, a power of two. */
        const val BLOCK = 1 shl 12

        val texturePairs = listOf("s", "t", "u", "v", "texture_u", "texture_v", "texture_s", "texture_t").chunked(2)
    }
}
