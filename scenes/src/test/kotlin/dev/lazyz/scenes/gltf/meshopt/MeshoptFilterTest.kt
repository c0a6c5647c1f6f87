package dev.lazyz.scenes.gltf.meshopt

import java.nio.ByteBuffer
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sign
import kotlin.math.sin
import kotlin.math.sqrt
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Filters lose precision, so that what comes out is near what the encoder got. */
class MeshoptFilterTest {
    private fun decoded(filter: String, stride: Int, bytes: ByteArray): ByteBuffer =
        MeshoptData("ATTRIBUTES", filter, 16, stride).decode(bytes)

    private fun assertNear(expected: Double, actual: Double, most: Double, what: String) =
        assertTrue(abs(expected - actual) <= most, "$what: $actual is not $expected")

    @Test
    fun unitVectors() {
        for (i in 0 until 16) {
            val z = 1 - i / 7.5
            val r = sqrt(maxOf(0.0, 1 - z * z))
            val bytes = decoded("OCTAHEDRAL", 4, MeshoptFixtures.octahedral8)
            val shorts = decoded("OCTAHEDRAL", 8, MeshoptFixtures.octahedral16)
            for ((k, x) in listOf(r * cos(i * 0.7), r * sin(i * 0.7), z).withIndex()) {
                assertNear(x, bytes.get(4 * i + k) / 127.0, 0.02, "vector $i")
                assertNear(x, shorts.getShort(8 * i + 2 * k) / 32767.0, 0.001, "vector $i")
            }
        }
    }

    @Test
    fun unitQuaternionsUpToTheirSign() {
        val shorts = decoded("QUATERNION", 8, MeshoptFixtures.quaternions)
        for (i in 0 until 16) {
            val q = listOf(sin(i * 1.0), cos(i * 2.0), sin(i * 3.0 + 1), cos(i * 5.0))
            val length = sqrt(q.sumOf { it * it })
            val side = q.maxBy { abs(it) }.sign
            for (k in 0 until 4) {
                val component = shorts.getShort(8 * i + 2 * k) / 32767.0
                assertNear(side * q[k] / length, component, 0.0002, "quaternion $i")
            }
        }
    }

    @Test
    fun floatsExactly() {
        val floats = decoded("EXPONENTIAL", 8, MeshoptFixtures.exponents)
        for (i in 0 until 16) {
            assertEquals((i - 8) * 1.25f, floats.getFloat(8 * i))
            assertEquals(StrictMath.scalb(3f, i - 8), floats.getFloat(8 * i + 4))
        }
    }

    @Test
    fun coloursWithAlpha() {
        val bytes = decoded("COLOR", 4, MeshoptFixtures.colors8)
        val shorts = decoded("COLOR", 8, MeshoptFixtures.colors16)
        for (i in 0 until 16) {
            for ((k, x) in listOf(i / 15.0, 1 - i / 15.0, i % 4 / 3.0, if (i % 2 == 1) 1.0 else 0.5).withIndex()) {
                assertNear(x, (bytes.get(4 * i + k).toInt() and 0xFF) / 255.0, 0.02, "colour $i")
                assertNear(x, (shorts.getShort(8 * i + 2 * k).toInt() and 0xFFFF) / 65535.0, 0.001, "colour $i")
            }
        }
    }
}
