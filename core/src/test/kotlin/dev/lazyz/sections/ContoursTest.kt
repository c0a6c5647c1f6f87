package dev.lazyz.sections

import java.time.Duration
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Test

class ContoursTest {
    /** Triangles that all have one corner in common, as where a plane cuts the tip of a fan. */
    @Test
    fun manyContoursThroughOnePointTakeLinearTime() {
        val tip = floatArrayOf(0f, 0f, 0f)
        val contours = Contours()
        for (i in 0 until MANY) {
            val near = floatArrayOf(1f, i.toFloat(), 0f)
            val far = floatArrayOf(2f, i.toFloat(), 0f)
            contours.add(tip, near)
            contours.add(near, far)
            contours.add(far, tip)
        }
        var loops = emptyList<FloatArray>()
        assertTimeoutPreemptively(Duration.ofSeconds(10)) { loops = contours.loops() }
        assertEquals(9 * MANY, loops.sumOf { it.size })
        assertEquals(0, contours.openCount)
    }

    private companion object {
        const val MANY = 300_000
    }
}
