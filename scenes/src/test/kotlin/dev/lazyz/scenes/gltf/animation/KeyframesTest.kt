package dev.lazyz.scenes.gltf.animation

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class KeyframesTest {
    private val times = floatArrayOf(1f, 2f, 4f)
    private val values = floatArrayOf(10f, 20f, 40f)

    private fun keyframes(interpolation: Interpolation, values: FloatArray = this.values) =
        Keyframes(times, values, 1, interpolation)

    @Test
    fun linesBetweenKeysAndTheEndsBeyondThem() {
        val line = keyframes(Interpolation.LINEAR)
        val expected = mapOf(0.0 to 10.0, 1.0 to 10.0, 1.25 to 12.5, 2.0 to 20.0, 3.0 to 30.0, 4.0 to 40.0, 9.0 to 40.0)
        for ((time, value) in expected) assertEquals(value, line.at(time).single(), "at $time")
    }

    @Test
    fun splinesHaveTangentsPerSecond() {
        // Tangent before, value, tangent after; from second 2 to 4 it is t^3 + t: 0 and 10 with slopes 1 and 13
        val spline = keyframes(Interpolation.CUBICSPLINE, floatArrayOf(9f, 0f, 0f, 9f, 0f, 1f, 13f, 10f, 9f))
        for (t in listOf(0.0, 0.5, 1.0, 1.75, 2.0)) {
            assertEquals(t * t * t + t, spline.at(2.0 + t).single(), 1e-12, "$t")
        }
        assertEquals(0.0, spline.at(0.0).single())
        assertEquals(10.0, spline.at(5.0).single())
    }

    @Test
    fun rotationsTakeTheShorterArcAtOneSpeed() {
        val h = StrictMath.sqrt(0.5).toFloat()

        // A quarter turn around z, whose second key is the same rotation with the other sign
        for (sign in listOf(1f, -1f)) {
            val values = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, sign * h, sign * h)
            val turn = Keyframes(floatArrayOf(0f, 1f), values, 4, Interpolation.LINEAR)
            val angle = StrictMath.PI / 4 / 3
            val expected = doubleArrayOf(0.0, 0.0, StrictMath.sin(angle), StrictMath.cos(angle))
            assertArrayEquals(expected, turn.rotationAt(1.0 / 3), 1e-7)
        }
    }

    @Test
    fun rotationsAreOfUnitLength() {
        val spline = Keyframes(
            floatArrayOf(0f),
            FloatArray(12) {
                if (it == 7) {
                    5f
                } else {
                    0f
                }
            },
            4, Interpolation.CUBICSPLINE
        )
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 0.0, 1.0), spline.rotationAt(0.0))
        val nothing = Keyframes(floatArrayOf(0f), FloatArray(4), 4, Interpolation.STEP)
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 0.0, 1.0), nothing.rotationAt(0.0))
    }
}
