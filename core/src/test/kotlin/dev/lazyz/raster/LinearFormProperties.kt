package dev.lazyz.raster

import dev.lazyz.Fraction
import dev.lazyz.GridPoint
import dev.lazyz.Raster
import dev.lazyz.setup.GuardBandTriangles
import dev.lazyz.spi.LinearForm
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 3.1 to 3.4: stepping, rounding, and the distance from exact rational arithmetic. */
class LinearFormProperties {
    @Property(seed = "1995", tries = 300, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_1_steppingAlongAnyPathEqualsDirectEvaluation(
        @ForAll c: Long,
        @ForAll dx: Long,
        @ForAll dy: Long,
        @ForAll random: Random,
    ) {
        val form = LinearForm(c, dx, dy)
        var x = random.nextInt(Raster.MAX_SIDE)
        var y = random.nextInt(Raster.MAX_SIDE)
        var value = form.at(x, y)
        repeat(100) {
            when (random.nextInt(4)) {
                0 -> {
                    x++
                    value += form.dx
                }
                1 -> {
                    x--
                    value -= form.dx
                }
                2 -> {
                    y++
                    value += form.dy
                }
                else -> {
                    y--
                    value -= form.dy
                }
            }
            assertEquals(form.at(x, y), value)
        }
    }

    @Property(seed = "1995", tries = 300)
    fun rule_3_2_theIntegerPartOfAConstantIsItself(@ForAll value: Int, @ForAll @IntRange(min = 0) x: Int) {
        val form = LinearForm.constant(value)
        assertEquals(value, (form.at(x, x) shr 32).toInt())
    }

    @Property(seed = "1995", tries = 2000, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_3_formsStayWithinTheirBound(
        @ForAll random: Random,
        @ForAll @IntRange(min = 0, max = 262143) column: Int,
        @ForAll @IntRange(min = 0, max = 262143) row: Int,
    ) {
        val triangle = GuardBandTriangles.around(random, column, row) ?: return
        val values = List(3) { value(random) }
        val form = reference(triangle).formUnlessSteep(values[0], values[1], values[2]) ?: return
        val exact = exactAt(triangle, values, column, row)
        val error = (Fraction(form.at(column, row) shr 32) - exact).abs()
        assertTrue(error < Fraction.of(ReferenceTriangle.ERROR_BOUND)) { "off by $error: $triangle, $values" }

        // With gentle slopes, only rounding remains
        val isGentle = Math.abs(form.dx) < 1L shl 50 && Math.abs(form.dy) < 1L shl 50
        if (isGentle) assertTrue(error < Fraction.of(0.501)) { "off by $error: $triangle, $values" }
    }

    @Property(seed = "1995", tries = 2000, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_4_onlySteepFormsAreConstant(
        @ForAll random: Random,
        @ForAll @IntRange(min = 0, max = 262143) column: Int,
        @ForAll @IntRange(min = 0, max = 262143) row: Int,
    ) {
        val triangle = GuardBandTriangles.around(random, column, row) ?: return
        val values = List(3) { value(random) }
        val steepest = steepest(triangle, values)
        val quarter = Fraction(1L shl 29)
        val form = reference(triangle).formUnlessSteep(values[0], values[1], values[2])
        if (steepest < quarter * Fraction.of(0.999999)) assertNotNull(form) { "$triangle, $values" }
        if (steepest > quarter * Fraction.of(1.000001)) assertEquals(null, form) { "$triangle, $values" }
        val orConstant = reference(triangle).form(values[0], values[1], values[2])
        assertEquals(form ?: LinearForm.constant(values[0]), orConstant)
    }

    @Property(seed = "1995", tries = 300, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_4_withoutAreaTheFormIsConstant(@ForAll random: Random) {
        val a = GridPoint(random.nextInt(5000), random.nextInt(5000))
        val step = GridPoint(random.nextInt(50) - 25, random.nextInt(50) - 25)
        val line = List(3) { random.nextInt(20) }.map { GridPoint(a.x + it * step.x, a.y + it * step.y) }
        assertEquals(LinearForm.constant(7), reference(line).form(7, random.nextInt(1000), random.nextInt(1000)))
    }

    /** The larger of the exact slopes a pixel, along a row and along a column. */
    private fun steepest(triangle: List<GridPoint>, values: List<Int>): Fraction {
        val sample = triangle[0]
        val at = { p: GridPoint -> planeAt(triangle, values, p) }
        val along = (at(GridPoint(sample.x + 256, sample.y)) - at(sample)).abs()
        val down = (at(GridPoint(sample.x, sample.y + 256)) - at(sample)).abs()
        return maxOf(along, down)
    }

    private fun exactAt(triangle: List<GridPoint>, values: List<Int>, column: Int, row: Int): Fraction =
        planeAt(triangle, values, GridPoint(256 * column + 128, 256 * row + 128))

    private fun planeAt(triangle: List<GridPoint>, values: List<Int>, p: GridPoint): Fraction {
        val coordinates = Fraction.barycentric(triangle[0], triangle[1], triangle[2], p)!!
        return Fraction.sum(coordinates.zip(values) { b, v -> b * Fraction(v.toLong()) })
    }

    private fun reference(t: List<GridPoint>) = ReferenceTriangle(t[0].x, t[0].y, t[1].x, t[1].y, t[2].x, t[2].y)

    private fun value(random: Random): Int = when (random.nextInt(3)) {
        0 -> random.nextInt(Int.MAX_VALUE)
        1 -> random.nextInt(1 shl 20) + 1000000000
        else -> if (random.nextBoolean()) 0 else Int.MAX_VALUE
    }
}
