package dev.lazyz.scenes.streaming

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A hilly square of [side] x [side] cells as OBJ and PLY files, with options. */
internal class IndexedHills(private val side: Int) {
    /** Corners of a face, 3 or 4. */
    var corners = 3
    var offset = 0.0
    var isColored = false
    var haveFacesColors = false

    /** Whether vertices have normals and texture coordinates. */
    var haveNormals = false
    var hasEdge = false
    var areStrips = false

    /** Whether the vertices come after the faces. */
    var isLast = false
    var lineEnd = "\n"

    private class Vertex(val position: List<Double>, val color: List<Int>)

    private val vertices: List<Vertex> get() = List((side + 1) * (side + 1)) { number ->
        val x = number % (side + 1) / side.toDouble()
        val y = number / (side + 1) / side.toDouble()
        val z = (StrictMath.sin(9 * x) * StrictMath.cos(7 * y) / 5).toFloat().toDouble()
        Vertex(listOf(x + offset, y - offset, z), listOf(number % 256, number / 7 % 256, number * 31 % 256))
    }

    private val faces: List<List<Int>> get() = (0 until side * side).flatMap { cell ->
        val a = cell / side * (side + 1) + cell % side
        val c = a + side + 1
        when {
            corners == 4 -> listOf(listOf(a, a + 1, c + 1, c))
            cell % 5 == 0 -> listOf(listOf(a, a + 1, c), listOf(a + 1, c + 1, c))
            else -> listOf(listOf(a, a + 1, c + 1), listOf(a, c + 1, c))
        }
    }

    /** The faces of a row of cells as one strip. */
    private val strips: List<List<Int>> get() = listOf(
        (0 until side).flatMap { y ->
            (0..side).flatMap { x -> listOf(y * (side + 1) + x, (y + 1) * (side + 1) + x) } + listOf(-1)
        },
    )

    fun obj(): String = buildString {
        for (vertex in vertices) {
            append("v ").append(vertex.position.joinToString(" "))
            if (isColored) vertex.color.forEach { append(" ").append(it / 256.0) }
            append(lineEnd)
            append('\n')
        }
        val count = vertices.size
        for ((number, face) in faces.withIndex()) {
            append("f")
            for (vertex in face) append(" ").append(if (number % 3 == 0) vertex - count else vertex + 1)
            append(lineEnd)
            append('\n')
        }
    }

    /** A file of this [format], with positions of type [number]. */
    fun ply(format: String, number: String = "float"): ByteArray {
        val out = Numbers(format)
        val elements = ArrayList<Pair<String, () -> Unit>>()
        val more = if (haveNormals) listOf("nx", "ny", "nz", "u", "v") else emptyList()
        val properties = listOf("x", "y", "z").map { "property $number $it\n" } +
            more.map { "property float $it\n" } +
            (if (isColored) COLORS else "")
        elements += "element vertex ${vertices.size}\n${properties.joinToString("")}" to {
            for (vertex in vertices) {
                for (value in vertex.position) if (number == "float") out.float(value) else out.double(value)
                repeat(more.size) { out.float(0.25) }
                if (isColored) vertex.color.forEach(out::code)
                out.endRow()
            }
        }
        val lists = if (areStrips) strips else faces
        val count = if (areStrips) "int" else "uchar"
        elements += "element ${if (areStrips) "tristrips" else "face"} ${lists.size}\n" +
            "property list $count int vertex_indices\n${if (haveFacesColors) COLORS else ""}" to {
                for ((row, list) in lists.withIndex()) {
                    if (areStrips) out.int(list.size) else out.code(list.size)
                    list.forEach(out::int)
                    if (haveFacesColors) repeat(3) { out.code((row * (it + 3)) % 256) }
                    out.endRow()
                }
            }
        if (hasEdge) {
            elements += "element edge 1\nproperty int vertex1\nproperty int vertex2\n" to {
                out.int(0)
                out.int(1)
                out.endRow()
            }
        }
        if (isLast) elements.reverse()
        out.text("ply\nformat $format 1.0\n" + elements.joinToString("") { it.first } + "end_header\n")
        for ((_, write) in elements) write()
        return out.bytes()
    }

    /** Numbers as text or in binary. */
    private class Numbers(private val format: String) {
        private val out = ByteArrayOutputStream()
        private val isText = format == "ascii"

        fun text(text: String) = out.write(text.toByteArray())

        private fun put(value: Any, size: Int, write: (ByteBuffer) -> Unit) {
            if (isText) return text("$value ")
            val order = if ("big" in format) ByteOrder.BIG_ENDIAN else ByteOrder.LITTLE_ENDIAN
            out.write(ByteBuffer.allocate(size).order(order).also(write).array())
        }

        fun float(value: Double) = put(value.toFloat(), 4) { it.putFloat(value.toFloat()) }

        fun double(value: Double) = put(value, 8) { it.putDouble(value) }

        fun int(value: Int) = put(value, 4) { it.putInt(value) }

        fun code(value: Int) = put(value, 1) { it.put(value.toByte()) }

        fun endRow() {
            if (isText) text("\n")
        }

        fun bytes(): ByteArray = out.toByteArray()
    }

    private companion object {
        const val COLORS = "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    }
}
