package dev.lazyz.setup

import dev.lazyz.shading.Vertices
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Clips at each plane of the guard band, and compares with explicit half-spaces. */
class ClipperTest {
    private val clipper = Clipper(3.0, 2.0, -0.5)

    /** Coefficients of x, y, z and w in the distance from each plane: near, far, left, right, bottom, top. */
    private val planes = listOf(
        listOf(0.0, 0.0, 1.0, 0.5), listOf(0.0, 0.0, -1.0, 1.0), listOf(1.0, 0.0, 0.0, 3.0),
        listOf(-1.0, 0.0, 0.0, 3.0), listOf(0.0, 1.0, 0.0, 2.0), listOf(0.0, -1.0, 0.0, 2.0),
    )

    private fun distance(plane: Int, point: List<Double>): Double =
        planes[plane].zip(point) { factor, component -> factor * component }.sum()

    private fun vertices(points: List<List<Double>>): Vertices {
        val vertices = Vertices(points.size)
        for ((i, point) in points.withIndex()) for (k in 0 until 4) vertices.set(i, Vertices.X + k, point[k])
        return vertices
    }

    private fun point(vertices: Vertices, vertex: Int) = List(4) { vertices.get(vertex, Vertices.X + it) }

    private fun isInside(point: List<Double>) = clipper.isInside(point[0], point[1], point[2], point[3])

    @Test
    fun rule_9_1_aPointOnAPlaneIsInside() {
        val random = Random(1)
        val onPlanes = IntArray(6)
        repeat(20_000) {
            // Quarters are exact
            val w = listOf(0.25, 0.5, 1.0, 2.0)[random.nextInt(4)]
            val point = List(3) { (random.nextInt(33) - 16) / 4.0 * w } + w
            val outside = planes.indices.filter { distance(it, point) < 0.0 }
            for (plane in planes.indices) if (distance(plane, point) == 0.0 && outside.isEmpty()) onPlanes[plane]++
            assertEquals(outside.sumOf { 1 shl it }, clipper.outcode(vertices(listOf(point)), 0)) { "$point" }
            assertEquals(outside.isEmpty(), isInside(point)) { "$point" }
        }
        assertTrue(onPlanes.all { it > 50 }) { "${onPlanes.toList()}" }
    }

    @Test
    fun rule_9_1_whatIsNowhereOrBehindTheEyeIsNotInside() {
        val inside = listOf(0.5, 0.25, 0.0, 1.0)
        assertTrue(isInside(inside))
        for (k in 0 until 4) {
            for (nowhere in listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)) {
                assertFalse(isInside(inside.toMutableList().also { it[k] = nowhere }))
            }
        }
        assertFalse(isInside(listOf(0.0, 0.0, 0.0, 0.0)))
        assertFalse(isInside(listOf(0.0, 0.0, 0.0, -1.0)))
        assertFalse(Clipper(-1.0, -1.0, 1.0).isInside(0.0, 0.0, -1.0, -1.0))
    }

    @Test
    fun rule_9_2_runsAlongAPlaneAreSplitWhereOthersEnd() {
        // A comb whose back is outside of the plane: coordinate 1 is on the plane, the other number is the position
        // along it
        val comb = listOf(
            0.5 to -0.75, 1.5 to -0.75, 1.5 to 0.75, 0.5 to 0.75, 0.5 to 0.25, 1.25 to 0.25, 1.25 to -0.25,
            0.5 to -0.25,
        )
        val cut = listOf(
            0.5 to -0.75, 1.0 to -0.75, 1.0 to -0.25, 1.0 to 0.25, 1.0 to 0.75, 0.5 to 0.75, 0.5 to 0.25, 1.0 to 0.25,
            1.0 to -0.25, 0.5 to -0.25,
        )
        for (plane in planes.indices) {
            for ((sign, offset) in listOf(1.0 to 0.0, -1.0 to 0.0, 1.0 to 1.0, -1.0 to 1.0)) {
                for (first in comb.indices) {
                    // The vertices have different w; positions are compared on the screen, wherever the contour begins
                    val points = List(comb.size) { i ->
                        val (across, along) = comb[(first + i) % comb.size]
                        place(plane, across, sign * along + offset).map { it * W[(first + 3 * i) % W.size] }
                    }
                    val vertices = vertices(points)
                    val contour = clipper.clip(vertices, listOf(IntArray(comb.size) { it }), 1 shl plane).single()
                    val actual = contour.map { point(vertices, it) }.map { point -> point.map { it / point[3] } }
                    val expected = cut.map { (across, along) -> place(plane, across, sign * along + offset) }
                    val start = actual.indexOfFirst { it.zip(expected[0]).all { (a, b) -> Math.abs(a - b) < 1e-12 } }
                    assertNear(expected, actual.drop(start) + actual.take(start))
                }
            }
        }
    }

    @Test
    fun rule_9_1_aCutIsReachedFromTheNearerEnd() {
        for (far in listOf(1e6, 1e20, 1e200)) {
            for ((near, other) in listOf(0.0 to far, 3.0 to far, 4.0 to -far)) {
                val vertices = vertices(listOf(near, other).map { listOf(it, 0.5, 0.0, 1.0) })
                val contour = clipper.clip(vertices, listOf(intArrayOf(0, 1)), 1 shl 3).single()
                val cuts = contour.filter { it > 1 }
                assertEquals(2, cuts.size)
                for (cut in cuts) assertEquals(3.0, vertices.get(cut, Vertices.X), 1e-12)
            }
        }
    }

    /** The point at the fraction [across] of the distance from the centre to a plane, and at [along] in the plane. */
    private fun place(plane: Int, across: Double, along: Double): List<Double> = when (plane) {
        0 -> listOf(along, along / 2, -0.5 * across, 1.0)
        1 -> listOf(along / 4, along, across, 1.0)
        2 -> listOf(-3.0 * across, along, 0.0, 1.0)
        3 -> listOf(3.0 * across, along, 0.0, 1.0)
        4 -> listOf(along, -2.0 * across, 0.0, 1.0)
        else -> listOf(along, 2.0 * across, 0.0, 1.0)
    }

    private fun assertNear(expected: List<List<Double>>, actual: List<List<Double>>) {
        assertEquals(expected.size, actual.size) { "$expected, $actual" }
        for ((a, b) in expected.flatten().zip(actual.flatten())) assertEquals(a, b, 1e-12) { "$expected, $actual" }
    }

    private companion object {
        val W = listOf(1.0, 0.125, 8.0, 0.5, 32.0)
    }
}
