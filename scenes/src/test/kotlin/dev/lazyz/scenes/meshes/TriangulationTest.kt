package dev.lazyz.scenes.meshes

import kotlin.math.cos
import kotlin.math.sin
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class TriangulationTest {
    private fun polygon(vararg xy: Double, z: Double = 0.0) =
        DoubleArray(xy.size / 2 * 3) { if (it % 3 == 2) z else xy[it / 3 * 2 + it % 3] }

    @Test
    fun fewCornersMakeFewTriangles() {
        assertEquals(0, Triangulation.triangles(doubleArrayOf())!!.size)
        assertEquals(0, Triangulation.triangles(polygon(0.0, 0.0, 1.0, 0.0))!!.size)
        assertArrayEquals(intArrayOf(0, 1, 2), Triangulation.triangles(polygon(0.0, 0.0, 1.0, 0.0, 0.0, 1.0)))
    }

    @Test
    fun convexPolygonIsAFanAroundItsFirstCorner() {
        val square = polygon(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0)
        assertArrayEquals(intArrayOf(0, 1, 2, 0, 2, 3), Triangulation.triangles(square))
        val clockwise = polygon(0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0)
        assertArrayEquals(intArrayOf(0, 1, 2, 0, 2, 3), Triangulation.triangles(clockwise))
    }

    @Test
    fun simplePolygonsAreCoveredOnceTheSameWayRound() {
        val random = Random(7)
        repeat(3000) { round ->
            val polygon = starShaped(random)
            val triangles = Triangulation.triangles(polygon)!!
            val corners = polygon.size / 3
            assertEquals(3 * (corners - 2), triangles.size, "round $round")

            // Areas with sign add up to the whole only if no triangle is turned and none overlaps
            val whole = area(polygon, IntArray(corners) { it })
            val normal = whole.map { it / length(whole) }
            val parts = triangles.toList().chunked(3).map { dot(area(polygon, it.toIntArray()), normal) }
            assertTrue(parts.all { it > -1e-9 * length(whole) }, "round $round: $parts")
            assertEquals(length(whole), parts.sum(), 1e-9 * length(whole), "round $round")
        }
    }

    @Test
    fun polygonWithoutAreaOrWithoutNumbersIsAFan() {
        val fan = intArrayOf(0, 1, 2, 0, 2, 3, 0, 3, 4)
        assertArrayEquals(fan, Triangulation.triangles(DoubleArray(15)))
        assertArrayEquals(fan, Triangulation.triangles(DoubleArray(15) { (it / 3).toDouble() }))
        for (bad in listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)) {
            for (place in 0 until 15) {
                val polygon = DoubleArray(15) { if (it == place) bad else (it * it % 7).toDouble() }
                assertArrayEquals(fan, Triangulation.triangles(polygon), "$bad at $place")
            }
        }
    }

    @Test
    fun starThatTurnsLeftTwiceIsNotTakenForConvex() {
        val pentagram = polygon(
            *DoubleArray(10) { 2 * Math.PI * 2 * (it / 2) / 5 }.mapIndexed { i, a ->
                if (i % 2 == 0) cos(a) else sin(a)
            }.toDoubleArray()
        )
        val fan = intArrayOf(0, 1, 2, 0, 2, 3, 0, 3, 4)
        assertTrue(!fan.contentEquals(Triangulation.triangles(pentagram)))
    }

    @Test
    fun polygonsThatCrossThemselvesAreSmall() {
        fun wild(corners: Int): DoubleArray {
            val random = Random(1)
            return DoubleArray(3 * corners) { if (it % 3 == 2) 0.0 else random.nextDouble() }
        }
        assertTrue(Triangulation.triangles(wild(Triangulation.MAX_CROSSING_CORNERS))!!.size > 3 * 100)
        assertNull(Triangulation.triangles(wild(Triangulation.MAX_CROSSING_CORNERS + 1)))
    }

    @Test
    fun onlyConcavePolygonsAreLimited() {
        val count = Triangulation.MAX_CONCAVE_CORNERS + 1
        val round = DoubleArray(3 * count) { corner(it, count, 1.0) }
        assertEquals(3 * (count - 2), Triangulation.triangles(round)!!.size)
        val notched = DoubleArray(3 * count) { corner(it, count, if (it / 3 == 5) 0.5 else 1.0) }
        assertNull(Triangulation.triangles(notched))
    }

    private fun corner(i: Int, count: Int, radius: Double): Double {
        val angle = 2 * Math.PI * (i / 3) / count
        return if (i % 3 == 0) {
            radius * cos(angle)
        } else if (i % 3 == 1) {
            radius * sin(angle)
        } else {
            0.0
        }
    }

    /** A polygon around a point, in a plane of any direction, either way round. */
    private fun starShaped(random: Random): DoubleArray {
        val corners = random.nextInt(4, 40)
        val u = List(3) { random.nextDouble(-1.0, 1.0) }
        val v = List(3) { random.nextDouble(-1.0, 1.0) }
        val centre = List(3) { random.nextDouble(-10.0, 10.0) }
        val polygon = DoubleArray(3 * corners)
        for (i in 0 until corners) {
            val angle = 2 * Math.PI * (i + 0.4 * random.nextDouble()) / corners
            val radius = random.nextDouble(0.2, 1.0)
            for (axis in 0 until 3) {
                polygon[3 * i + axis] = centre[axis] + radius * (cos(angle) * u[axis] + sin(angle) * v[axis])
            }
        }
        return polygon
    }

    /** The area of the polygon with these corners, as a vector along its normal. */
    private fun area(xyz: DoubleArray, corners: IntArray): List<Double> {
        val sum = DoubleArray(3)
        for (i in corners.indices) {
            val p = 3 * corners[i]
            val q = 3 * corners[(i + 1) % corners.size]
            for (axis in 0 until 3) {
                val a = (axis + 1) % 3
                val b = (axis + 2) % 3
                sum[axis] +=
                    (xyz[p + a] - xyz[a]) * (xyz[q + b] - xyz[b]) - (xyz[p + b] - xyz[b]) * (xyz[q + a] - xyz[a])
            }
        }
        return sum.toList()
    }

    private fun dot(a: List<Double>, b: List<Double>) = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    private fun length(a: List<Double>) = Math.sqrt(dot(a, a))
}
