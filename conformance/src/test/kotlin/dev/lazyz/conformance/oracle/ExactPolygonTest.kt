package dev.lazyz.conformance.oracle

import dev.lazyz.geometry.FillRule
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class ExactPolygonTest {
    @Test
    fun fillRuleDecidesWhereContoursOverlap() {
        val contours = listOf(
            intArrayOf(0, 0, 0, 1280, 0, 0, 1280, 768, 0, 0, 768, 0),
            intArrayOf(256, 256, 0, 1024, 256, 0, 1024, 512, 0, 256, 512, 0),
        )
        assertEquals(listOf("#####", "#...#", "#####"), picture(ExactPolygon(contours, FillRule.EVEN_ODD), 5, 3))
        assertEquals(listOf("#####", "#####", "#####"), picture(ExactPolygon(contours, FillRule.NON_ZERO), 5, 3))
    }

    @Test
    fun depthErrorIsTheDistanceToThePlane() {
        // 256 units per pixel to the right, 1024 downward; 640 at the sample of (0, 0)
        val polygon = ExactPolygon(listOf(intArrayOf(0, 0, 0, 1024, 0, 1024, 0, 1024, 4096)), FillRule.NON_ZERO)
        assertEquals(0.0, polygon.depthError(0, 0, 640))
        assertEquals(2.0, polygon.depthError(1, 0, 894))
        assertEquals(3.0, polygon.depthError(0, 1, 1667))
    }

    @Test
    fun planeGoesThroughTheVerticesThatLieWellApart() {
        // The second vertex is close to the first and not in the plane of the others
        val polygon = ExactPolygon(
            listOf(intArrayOf(0, 0, 1000, 1, 1, 1100, 2560, 0, 1000, 2560, 2560, 1000)), FillRule.NON_ZERO,
        )
        assertEquals(0.0, polygon.depthError(5, 5, 1000))
    }

    @Test
    fun depthIsTheFirstVertexWhereThePlaneIsTooSteep() {
        val sliver = intArrayOf(0, 0, 1 shl 24, 256, 0, (1 shl 24) + (1 shl 29), 0, 256, 1 shl 24)
        assertEquals(5.0, ExactPolygon(listOf(sliver), FillRule.NON_ZERO).depthError(0, 0, (1 shl 24) + 5))
        sliver[5]--
        assertEquals((1 shl 28) - 0.5, ExactPolygon(listOf(sliver), FillRule.NON_ZERO).depthError(0, 0, 1 shl 24))
    }

    @Test
    fun incompleteContoursAreRefused() {
        assertThrows(IllegalArgumentException::class.java) { ExactPolygon(listOf(IntArray(10)), FillRule.NON_ZERO) }
        assertThrows(IllegalArgumentException::class.java) { ExactPolygon(listOf(IntArray(6)), FillRule.NON_ZERO) }
        assertThrows(IllegalArgumentException::class.java) { ExactPolygon(emptyList(), FillRule.NON_ZERO) }
    }

    private fun picture(polygon: ExactPolygon, width: Int, height: Int): List<String> =
        List(height) { y -> (0 until width).joinToString("") { x -> if (polygon.covers(x, y)) "#" else "." } }
}
