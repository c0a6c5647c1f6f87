package dev.lazyz.cli.render

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A hilly square of 2 x [side] x [side] triangles as a file. */
internal class Hills(private val side: Int) {
    private fun height(x: Int, y: Int): Float =
        (StrictMath.sin(11.0 * x / side) * StrictMath.cos(8.0 * y / side) / 6).toFloat()

    /** Returns a binary STL file. */
    fun stl(): ByteArray {
        val buffer = ByteBuffer.allocate(84 + 100 * side * side).order(ByteOrder.LITTLE_ENDIAN)
        buffer.position(80).putInt(2 * side * side)
        fun point(x: Int, y: Int) {
            buffer.putFloat(x / side.toFloat()).putFloat(y / side.toFloat()).putFloat(height(x, y))
        }
        for (y in 0 until side) {
            for (x in 0 until side) {
                for (upper in 0..1) {
                    buffer.position(buffer.position() + 12)
                    point(x, y)
                    point(x + 1, y + upper)
                    point(x + 1 - upper, y + 1)
                    buffer.position(buffer.position() + 2)
                }
            }
        }
        return buffer.array()
    }

    /** Returns an OBJ file, in which triangles share vertices. */
    fun obj(): String = buildString {
        vertices("v ")
        triangles("f ", first = 1)
    }

    /** Returns a text PLY file, in which triangles share vertices. */
    fun ply(): String = buildString {
        append("ply\nformat ascii 1.0\nelement vertex ${(side + 1) * (side + 1)}\nproperty float x\n")
        append("property float y\nproperty float z\nelement face ${2 * side * side}\n")
        append("property list uchar int vertex_index\nend_header\n")
        vertices("")
        triangles("3 ", first = 0)
    }

    private fun StringBuilder.vertices(start: String) {
        for (y in 0..side) {
            for (x in 0..side) {
                append(start).append(x / side.toFloat()).append(' ').append(y / side.toFloat())
                append(' ').append(height(x, y)).append('\n')
            }
        }
    }

    private fun StringBuilder.triangles(start: String, first: Int) {
        for (y in 0 until side) {
            for (x in 0 until side) {
                val a = y * (side + 1) + x + first
                val c = a + side + 1
                append(start).append(a).append(' ').append(a + 1).append(' ').append(c + 1).append('\n')
                append(start).append(a).append(' ').append(c + 1).append(' ').append(c).append('\n')
            }
        }
    }
}
