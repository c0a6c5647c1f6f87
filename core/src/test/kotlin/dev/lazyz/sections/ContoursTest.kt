package dev.lazyz.sections

import dev.lazyz.shared.ProcessorTime
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ContoursTest {
    /** Triangles that all have one corner in common, as where a plane cuts the tip of a fan. */
    @Test
    fun manyContoursThroughOnePointTakeLinearTime() = ProcessorTime.assertLinear(64_000, ::fan) { contours, many ->
        assertEquals(9 * many, contours.loops().sumOf { it.size })
        assertEquals(0, contours.openCount)
    }

    private fun fan(many: Int): Contours {
        val tip = floatArrayOf(0f, 0f, 0f)
        val contours = Contours()
        for (i in 0 until many) {
            val near = floatArrayOf(1f, i.toFloat(), 0f)
            val far = floatArrayOf(2f, i.toFloat(), 0f)
            contours.add(tip, near)
            contours.add(near, far)
            contours.add(far, tip)
        }
        return contours
    }

    /** Opposite segments cancel, and others count once however often they are there. */
    @Test
    fun rule_10_5_aContourHasEachSegmentOnce() {
        val corners = listOf(floatArrayOf(0f, 0f, 0f), floatArrayOf(1f, 0f, 0f), floatArrayOf(1f, 1f, 0f))
        var open = 0
        fun loops(vararg segments: Pair<Int, Int>): List<List<Float>> {
            val contours = Contours()
            for ((from, to) in segments) contours.add(corners[from], corners[to])
            return contours.loops().map { it.toList() }.also { open = contours.openSegments.size }
        }
        val triangle = loops(0 to 1, 1 to 2, 2 to 0)
        assertEquals(9, triangle.single().size)
        assertEquals(triangle, loops(0 to 1, 1 to 2, 2 to 0, 0 to 1, 1 to 2))
        assertEquals(triangle, loops(0 to 1, 1 to 0, 1 to 2, 2 to 0, 0 to 1))
        assertEquals(0, open)
        assertEquals(emptyList<List<Float>>(), loops(0 to 1, 1 to 2, 2 to 0, 1 to 0))
        assertEquals(2, open, "segments that are left")
    }

    /** Surfaces whose neighbours have opposite orders of vertices: segments lead away from a point, or toward it. */
    @Test
    fun rule_10_5_anOpenContourIsOpenWhateverItsDirections() {
        val corners = List(4) { floatArrayOf(it.toFloat(), (it % 2).toFloat(), 0f) }
        for (directions in 0 until 8) {
            val contours = Contours()
            val segments = List(3) { if (directions shr it and 1 == 0) it to it + 1 else it + 1 to it }
            for ((from, to) in segments) contours.add(corners[from], corners[to])
            assertEquals(emptyList<FloatArray>(), contours.loops()) { "$segments" }
            assertEquals(1, contours.openCount) { "$segments" }

            // They can still be joined to others, so they keep their directions
            val expected = segments.map { (from, to) -> (corners[from] + corners[to]).toList() }
            assertEquals(expected.toSet(), contours.openSegments.map { it.toList() }.toSet()) { "$segments" }
        }
    }
}
