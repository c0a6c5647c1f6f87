package dev.lazyz.scenes.builtin

import java.nio.ByteBuffer
import java.util.zip.CRC32
import kotlin.math.abs
import kotlin.math.sqrt
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class TeapotTest {
    @Test
    fun segmentsOutOfRangeAreRejected() {
        for (n in listOf(Int.MIN_VALUE, -1, 0, 257, Int.MAX_VALUE)) {
            val error = assertThrows(IllegalArgumentException::class.java) { Teapot.tessellate(n) }
            assertEquals("segments must be in 1..256: $n", error.message)
        }
    }

    @Test
    fun trianglesAreCounterClockwiseFromOutside() {
        // Coarser ones cut the corners of knob and rim, where triangles and normals no longer agree
        for (n in listOf(7, 10, 32)) {
            val mesh = Teapot.tessellate(n)
            for (triangle in 0 until mesh.triangleCount) {
                val (a, b, c) = mesh.corners(triangle)
                val facing = cross(minus(mesh.position(b), mesh.position(a)), minus(mesh.position(c), mesh.position(a)))
                val outward = plus(mesh.normal(a), plus(mesh.normal(b), mesh.normal(c)))
                assertTrue(dot(facing, outward) > 0.0, "triangle $triangle at n = $n")
            }
        }
    }

    @Test
    fun patchesMeetWithoutCracks() {
        // n = 1 flattens the handle's two sides into one plane, so edges there coincide more than twice
        for (n in listOf(2, 3, 7, 10, 32)) {
            val mesh = Teapot.tessellate(n)
            val uses = directedEdges(mesh)
            for ((edge, count) in uses) assertEquals(1, count, "uses of edge $edge at n = $n")
            val open = uses.keys.filter { (from, to) -> (to to from) !in uses }
            // Sixteen patch borders have no neighbour: the inside of the rim (4) and the edge of the lid (4), which
            // rest on each other without touching; both ends of the handle (2 + 2), the start of the spout (2), which
            // only pass through the body; the inside of the lip (2). Any crack would add to them.
            assertEquals(16 * n, open.size, "open edges at n = $n")
            // The open edges are those, and no others
            val borders = open.groupingBy { (from, _) -> openBorder(from) }.eachCount()
            val expected = mapOf("rim" to 4, "lid" to 4, "handle top" to 2, "handle end" to 2, "spout" to 2, "lip" to 2)
            assertEquals(expected.mapValues { it.value * n }, borders, "open borders at n = $n")
        }
    }

    @Test
    fun bitsAreTheSameOnEveryMachine() {
        val mesh = Teapot.tessellate(7)
        assertEquals(POSITION_CRC, crc(mesh.positions.map { it.toRawBits() }), "positions")
        assertEquals(NORMAL_CRC, crc(mesh.normals.map { it.toRawBits() }), "normals")
        assertEquals(UV_CRC, crc(mesh.uvs.map { it.toRawBits() }), "uvs")
        assertEquals(TRIANGLE_CRC, crc(mesh.triangles.toList()), "triangles")
    }

    private fun crc(words: List<Int>): Long {
        val bytes = ByteBuffer.allocate(4 * words.size)
        words.forEach(bytes::putInt)
        return CRC32().apply { update(bytes.array()) }.value
    }

    private fun openBorder(key: List<Int>): String {
        val (x, y, z) = key.map { Float.fromBits(it).toDouble() }
        val radius = sqrt(x * x + z * z)
        return when {
            x > 3.2 || (x > 2.7 && y > 2.3) -> "lip"
            x < -1.85 && y < 1.0 -> "handle end"
            x <= -1.5 && abs(z) < 0.3 -> "handle top"
            abs(y - 2.4f) < 1e-6 && radius < 1.35 -> "lid"
            abs(y - 2.4f) < 1e-6 && radius < 1.45 -> "rim"
            x == 1.7f.toDouble() -> "spout"
            else -> "unexpected at $x, $y, $z"
        }
    }

    /** How often each directed edge, from position bits to position bits, is used. */
    private fun directedEdges(mesh: TeapotMesh): Map<Pair<List<Int>, List<Int>>, Int> {
        val uses = HashMap<Pair<List<Int>, List<Int>>, Int>()
        for (triangle in 0 until mesh.triangleCount) {
            val corners = mesh.corners(triangle).map { bits(mesh.positions, it) }
            for (corner in 0 until 3) uses.merge(corners[corner] to corners[(corner + 1) % 3], 1, Int::plus)
        }
        return uses
    }

    private fun TeapotMesh.corners(triangle: Int) = List(3) { triangles[3 * triangle + it] }

    private fun TeapotMesh.position(vertex: Int) = DoubleArray(3) { positions[3 * vertex + it].toDouble() }

    private fun TeapotMesh.normal(vertex: Int) = DoubleArray(3) { normals[3 * vertex + it].toDouble() }

    private fun bits(values: FloatArray, vertex: Int) = List(3) { values[3 * vertex + it].toRawBits() }

    private fun plus(a: DoubleArray, b: DoubleArray) = DoubleArray(3) { a[it] + b[it] }

    private fun minus(a: DoubleArray, b: DoubleArray) = DoubleArray(3) { a[it] - b[it] }

    private fun dot(a: DoubleArray, b: DoubleArray) = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    private fun cross(a: DoubleArray, b: DoubleArray) =
        DoubleArray(3) { a[(it + 1) % 3] * b[(it + 2) % 3] - a[(it + 2) % 3] * b[(it + 1) % 3] }

    private companion object {
        // Computed apart from this code, from the published numbers, with the same order of operations
        const val POSITION_CRC = 0xafd32e93L
        const val NORMAL_CRC = 0xca351dc1L
        const val UV_CRC = 0x0d2a09ccL
        const val TRIANGLE_CRC = 0xcaaa89f4L
    }
}
