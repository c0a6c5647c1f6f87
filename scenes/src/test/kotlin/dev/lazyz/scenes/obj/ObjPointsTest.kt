package dev.lazyz.scenes.obj

import dev.lazyz.Rgba
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Statements `p` and `l`. */
class ObjPointsTest {
    private val square = "v 0 0 0\nv 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0\n"

    private fun surfaces(text: String): List<Surface> = ObjParser.parse(TestSources.of(square + text)).surfaces

    @Test
    fun pointsAreThoseVertices() {
        val points = surfaces("p 3 1\np -1\n").single() as Points
        assertArrayEquals(floatArrayOf(1f, 1f, 0f, 0f, 0f, 0f, 0f, 1f, 0f), points.positions)
        assertArrayEquals(floatArrayOf(1f, 0f, 0f, 1f, 1f, 1f, 1f, 1f, 1f, 1f, 1f, 1f), points.colors)
    }

    @Test
    fun verticesOfAModelWithoutAnythingElseArePoints() {
        val points = surfaces("vn 0 0 1\ng a\n").single() as Points
        assertArrayEquals(floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 1f, 1f, 0f, 0f, 1f, 0f), points.positions)
        assertEquals(listOf(1f, 0f, 0f, 1f), points.colors?.slice(8..11))
        val plain = ObjParser.parse(TestSources.of("v 1 2 3\n")).surfaces.single() as Points
        assertNull(plain.colors)
        assertNotEquals(Rgba.WHITE, plain.material.baseColor)
    }

    @Test
    fun aLineIsAPolyline() {
        val lines = surfaces("vt 0 0\nl 2/1 3/1 4/1\nl 4 2\n").single() as Lines
        assertArrayEquals(intArrayOf(0, 1, 1, 2, 2, 0), lines.segments)
        assertArrayEquals(floatArrayOf(1f, 0f, 0f, 1f, 1f, 0f, 0f, 1f, 0f), lines.positions)
        assertArrayEquals(floatArrayOf(1f, 1f, 1f, 1f, 1f, 0f, 0f, 1f, 1f, 1f, 1f, 1f), lines.colors)
    }

    @Test
    fun pointsAndLinesFollowTheMeshesByMaterial() {
        val all = surfaces("l 1 2\np 1\nusemtl a\nl 2 3\nf 1 2 3\nusemtl b\nl 3 4\nusemtl a\nl 4 1\n")
        assertTrue(all[0] is Mesh && all[1] is Points)
        val lines = all.drop(2).map { it as Lines }
        assertEquals(listOf(1, 2, 1), lines.map { it.segmentCount })
        assertEquals(listOf("", "a", "b"), lines.map { it.material.name })
    }

    @Test
    fun wrongNumbersAreRefused() {
        fun message(text: String) = TestSources.error(ObjParser, TestSources.of(square + text)).message!!
        assertTrue("line 5" in message("p 5\n"))
        assertTrue("number 6 of 4 vertices" in message("l 1 6\n"))
        assertTrue("the line refers to number -5" in message("l 1 -5\n"))
        assertTrue("the point refers" in message("p -9\n"))
        assertTrue("\"x\" cannot number a vertex" in message("l 1 x\n"))
    }
}
