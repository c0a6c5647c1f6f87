package dev.lazyz.scenes.ply

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.SrgbDecoding
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Reads the element `vertex`, with positions relative to [origin].
 *
 * @param isBare whether only positions and colours are read
 */
internal class PlyVertices(
    private val source: Source,
    private val element: PlyElement,
    private val origin: Vector3dc,
    isBare: Boolean = false,
) {
    /** The numbers of the columns x, y and z. */
    val position: IntArray = listOf("x", "y", "z").map { name ->
        element.column(listOf(name)) ?: source.fail("header", "element vertex has no property $name", "add it")
    }.toIntArray()
    private val normal = if (isBare) null else columns(listOf("nx", "ny", "nz"))
    private val texture = if (isBare) null else texturePairs.firstNotNullOfOrNull(::columns)
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
        val vertices = arrays(room)
        return vertices.first(read(body, vertices) { error("there are more than $room rows") })
    }

    /** Reads all rows that are present, and passes them to [use] in order, some thousands at a time. */
    fun read(body: PlyBody, use: (block: VertexArrays, count: Int) -> Unit) {
        val block = arrays(BLOCK)
        val count = read(body, block) { use(block, BLOCK) }
        use(block, count)
    }

    private fun arrays(count: Int) = VertexArrays(
        FloatArray(3 * count),
        normal?.let { FloatArray(3 * count) },
        texture?.let { FloatArray(2 * count) },
        color?.let { FloatArray(4 * count) },
        origin,
    )

    /**
     * Reads all rows that are present into [to]. Whenever it is full and there are more rows, calls [full] and begins
     * again with its first vertex. Returns the number of vertices that [to] has at the end.
     */
    private inline fun read(body: PlyBody, to: VertexArrays, full: () -> Unit): Int {
        val capacity = to.count
        var next = 0
        if (body is PlyBinaryBody && areFloats()) {
            val floats = FloatRow()
            body.eachRow(element) { at ->
                if (next == capacity) next = 0.also { full() }
                floats.set(to, next++, body, at)
            }
        } else {
            body.readRows(element) { _, row ->
                if (next == capacity) next = 0.also { full() }
                set(to, next, row)
                setColor(to, next++, row)
            }
        }
        return next
    }

    /** Whether all columns in use are floats, and bytes for colours. */
    private fun areFloats(): Boolean {
        val floats = listOfNotNull(position, normal, texture).flatMap { it.toList() }
        return !element.hasLists && floats.all { element.properties[it].type == PlyType.FLOAT } &&
            color?.columns.orEmpty().all { element.properties[it].type == PlyType.UCHAR }
    }

    /** A fast path for [set] that reads rows directly from the bytes. */
    private inner class FloatRow {
        private val places =
            element.properties.runningFold(0) { place, property -> place + property.type.size }.toIntArray()
        private val positionPlaces = IntArray(3) { places[position[it]] }
        private val row = PlyRow(element)

        /** Writes the row at index [at] of [body]. */
        fun set(to: VertexArrays, vertex: Int, body: PlyBinaryBody, at: Int) {
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
        /** Vertices that are passed on at a time. */
        const val BLOCK = 1 shl 12
        val texturePairs = listOf("s", "t", "u", "v", "texture_u", "texture_v", "texture_s", "texture_t").chunked(2)
    }
}

/**
 * The columns of a colour. Red, green and blue are sRGB-encoded; alpha is linear. Numbers are integers in the range of
 * their type, or fractions in 0..1. Splats, which have no colours, have the first coefficient of spherical harmonics,
 * whose colour from all sides is 0.5 plus [HARMONIC] times the coefficient (B. Kerbl et al., "3D Gaussian Splatting for
 * Real-Time Radiance Field Rendering", 2023).
 */
internal class PlyColor private constructor(
    private val channels: IntArray,
    private val alpha: Int?,
    private val areCoefficients: Boolean,
) {
    /** The numbers of all columns. */
    val columns: List<Int> = channels.toList() + listOfNotNull(alpha)

    /** Returns red (0), green (1), blue (2), all linear, or alpha (3) of [row]. */
    fun channel(row: PlyRow, channel: Int): Float {
        if (channel == 3) return if (alpha == null) 1f else (row.numbers[alpha] / most(row, alpha)).toFloat()

        // Bytes are decoded with a table, so that they give the same colours as the same bytes in a texture
        val column = channels[channel]
        val number = row.numbers[column]
        val isCode = row.properties[column].type == PlyType.UCHAR
        if (areCoefficients) return Rgba.linearOf((0.5 + HARMONIC * number).coerceIn(0.0, 1.0))
        if (isCode) return SrgbDecoding.decodeByte(number.toInt().coerceIn(0, 255))
        return Rgba.linearOf(number / most(row, column))
    }

    private fun most(row: PlyRow, column: Int): Double = row.properties[column].type.most

    companion object {
        /** The value of the spherical harmonic of degree 0, 1 / (2 sqrt(pi)). */
        private const val HARMONIC = 0.28209479177387814

        /** Returns the colour of [element]'s rows, or null if they have none. */
        fun of(element: PlyElement): PlyColor? {
            val channels = listOf("red", "green", "blue").mapNotNull { column(element, it) }
            if (channels.size == 3) return PlyColor(channels.toIntArray(), column(element, "alpha"), false)
            val coefficients = List(3) { "f_dc_$it" }.mapNotNull { element.column(listOf(it)) }
            return if (coefficients.size < 3) null else PlyColor(coefficients.toIntArray(), null, true)
        }

        private fun column(element: PlyElement, name: String): Int? =
            element.column(listOf(name, "diffuse_$name", name.substring(0, 1)))
    }
}
