package dev.lazyz.sections

import dev.lazyz.drawing.Solids
import dev.lazyz.geometry.FillRule
import dev.lazyz.sections.Section
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Where a plane cuts polygons, their sides in the plane are sides of what remains. */
class ContourCutTest {
    private fun polygons(surface: Surface, vararg planes: Section.Plane): List<Polygon> =
        Section(planes.toList()).of(Scene(listOf(surface))).scene.surfaces.filterIsInstance<Polygon>()

    private fun cut(polygon: Polygon, plane: Section.Plane): List<List<Vertex>> =
        polygons(polygon, plane).singleOrNull()?.contours.orEmpty()

    private fun sides(contours: List<List<Vertex>>): List<Pair<Vertex, Vertex>> =
        contours.flatMap { contour -> contour.indices.map { contour[it] to contour[(it + 1) % contour.size] } }

    private fun contour(vararg places: Int): List<Vertex> =
        places.toList().chunked(2).map { (x, y) -> Vertex(x.toDouble(), y.toDouble(), 0.0) }

    /** Sums of windings left of a place in the plane z = 0, for a number that no side has as its y. */
    private fun windings(contours: List<List<Vertex>>, x: Double, y: Double): List<Int> = sides(contours)
        .filter { (a, b) -> (a.y < y) != (b.y < y) && a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x) < x }
        .map { (a, b) -> if (a.y < b.y) 1 else -1 }

    private fun isInside(contours: List<List<Vertex>>, rule: FillRule, x: Double, y: Double): Boolean =
        windings(contours, x, y).let { if (rule == FillRule.EVEN_ODD) it.size % 2 != 0 else it.sum() != 0 }

    /** A pipe along the y axis, cut across and then lengthwise: no side leads over the bore. */
    @Test
    fun rule_10_5_aCapThatIsCutThroughAHoleHasNoSideAcrossIt() {
        val outside = Solids.cube()
        val bore = Solids.box(-0.5f, -1f, -0.5f, 0.5f, 1f, 0.5f)
        val pipe = Mesh(
            outside.positions + bore.positions,
            outside.triangles + bore.triangles.reversedArray().map { it + 8 }.toIntArray(),
        )
        for (planes in listOf(
            listOf(Section.Plane.y(0.3), Section.Plane.x(0.05)), listOf(Section.Plane.x(0.05), Section.Plane.y(0.3)),
        )) {
            val caps = polygons(pipe, *planes.toTypedArray())
            val across = caps[planes.indexOfFirst { it.normal.y() == 1.0 }]
            assertEquals(1, across.contours.size)
            val inPlane = sides(across.contours).filter { (a, b) -> minOf(a.x, b.x) > 0.049 }
            assertEquals(2, inPlane.size)
            for ((a, b) in inPlane) assertEquals(0.5, StrictMath.abs(a.z - b.z), 1e-9) { "$a $b" }
        }
    }

    /** Contours with random vertices on a coarse grid: they cross and overlap, and have sides in the plane. */
    @Test
    fun rule_10_4_sidesInThePlaneAreThoseOfWhatRemains() {
        val random = Random(41)
        var bridges = 0
        repeat(3000) { number ->
            val contours = List(1 + random.nextInt(3)) {
                contour(*IntArray(6 + 2 * random.nextInt(4)) { random.nextInt(7) })
            }
            if (contours.flatten().all { it.y <= 3.0 }) return@repeat
            val rule = FillRule.entries[number % 2]
            val cut = cut(Polygon(contours, fillRule = rule), Section.Plane.y(3.0))
            for ((a, b) in sides(cut)) {
                if (a.y != 3.0 || b.y != 3.0 || StrictMath.abs(a.x - b.x) < 1e-6) continue
                val between = a.x + 0.4831 * (b.x - a.x)
                assertTrue(isInside(contours, rule, between, 3.0 - 1e-6)) { "$contours: $a $b" }
                bridges++
            }
            repeat(20) {
                val x = 6 * random.nextDouble()
                val y = 6 * random.nextDouble()
                val expected = y < 3.0 && isInside(contours, rule, x, y)
                assertEquals(expected, isInside(cut, rule, x, y)) { "$contours at ($x, $y): $cut" }
            }
        }
        assertTrue(bridges > 1000) { "$bridges" }
    }
}
