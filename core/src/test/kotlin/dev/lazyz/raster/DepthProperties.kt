package dev.lazyz.raster

import dev.lazyz.Depth
import dev.lazyz.Fraction
import dev.lazyz.Frame
import dev.lazyz.GridDrawing
import dev.lazyz.GridPoint
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.geometry.FillRule
import dev.lazyz.samples
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.setup.GuardBandTriangles
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Spans
import java.math.BigDecimal
import java.math.RoundingMode
import java.util.Random
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.Example
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide
import net.jqwik.api.constraints.DoubleRange
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 3.4, 3.5 and 4: depth. */
class DepthProperties {
    private val shader = Shader { it.setColor(1f, 1f, 1f) }

    @Provide
    fun drawings(): Arbitrary<GridDrawing> = GridDrawing.any()

    @Provide
    fun units(): Arbitrary<List<Double>> = Arbitraries.doubles().between(0.0, 1.0).ofScale(9).list().ofSize(21)

    @Property(seed = "1995", tries = 1000)
    fun rule_4_2_depthIsTheNearestIntegerBetweenThePlanes(@ForAll @DoubleRange(min = 0.0, max = 1.0) unit: Double) {
        val near = BigDecimal(1 shl 24)
        val range = BigDecimal(Int.MAX_VALUE).subtract(near).subtract(near)
        val exact = near.add(BigDecimal(unit).multiply(range))
        val error = exact.subtract(BigDecimal(Depth.ofUnit(unit))).abs()
        assertTrue(error <= BigDecimal("0.500001")) { "$unit became ${Depth.ofUnit(unit)}, off by $error" }
        assertTrue(Math.abs(Depth.toUnit(Depth.ofUnit(unit)) - unit) < 1e-9)
    }

    @Property(seed = "1995", tries = 500)
    fun rule_4_2_whatLiesOutsideThePlanesIsClamped(@ForAll unit: Double) {
        assertTrue(Depth.ofUnit(unit) in (1 shl 24)..(Int.MAX_VALUE - (1 shl 24)))
        assertEquals(Depth.NEAR, Depth.ofUnit(-0.001))
        assertEquals(Depth.FAR, Depth.ofUnit(1.001))
    }

    @Property(seed = "1995", tries = 1500, edgeCases = EdgeCasesMode.NONE)
    fun rule_4_4_depthOfTrianglesIsWithinAUnitOfExact(
        @ForAll random: Random,
        @ForAll @IntRange(min = 0, max = 262143) column: Int,
        @ForAll @IntRange(min = 0, max = 262143) row: Int,
        @ForAll("units") units: List<Double>,
    ) {
        val triangle = GuardBandTriangles.around(random, column, row) ?: return
        val depths = List(3) { Depth.ofUnit(units[it]) }
        val raster = Raster(Raster.MAX_SIDE, Raster.MAX_SIDE)
        val contour = triangle.flatMapIndexed { i, p -> listOf(p.pixelX, p.pixelY, units[i]) }.toDoubleArray()
        val primitive = FrameBuilder(raster).polygon(shader, FillRule.NON_ZERO, contour).build().primitives.single()
        val form = primitive.depthForm ?: return
        val isConstant = form.dx == 0L && form.dy == 0L

        // At both ends and in the middle of the spans of the row
        val spans = Spans()
        primitive.spans(row, spans)
        for (i in 0 until spans.count) {
            for (x in setOf(spans.start(i), (spans.start(i) + spans.end(i)) / 2, spans.end(i) - 1)) {
                val sample = GridPoint(256 * x + 128, 256 * row + 128)
                val coordinates = Fraction.barycentric(triangle[0], triangle[1], triangle[2], sample)!!
                val exact = Fraction.sum(coordinates.zip(depths) { b, d -> b * Fraction(d.toLong()) })
                val depth = primitive.depth(x, row)
                assertEquals(depth, (form.at(x, row) shr 32).toInt())
                assertTrue(depth in primitive.leastDepth..primitive.greatestDepth) { "$depth is outside the bounds" }
                if (isConstant) continue
                assertTrue((exact - Fraction(depth.toLong())).abs() < Fraction(1)) { "$depth instead of $exact at $x" }
            }
        }
    }

    @Property(seed = "1995", tries = 1000, edgeCases = EdgeCasesMode.NONE)
    fun rule_4_4_depthIsInRangeHoweverBentThePolygon(
        @ForAll("drawings") drawing: GridDrawing,
        @ForAll("units") units: List<Double>,
    ) {
        var vertex = 0
        val contours = drawing.contours.map { contour ->
            contour.flatMap { listOf(it.pixelX, it.pixelY, Math.rint(units[vertex++]) * 0.6 + units[vertex - 1] * 0.4) }
        }
        val frame = FrameBuilder(drawing.raster)
            .polygon(shader, FillRule.NON_ZERO, *contours.map { it.toDoubleArray() }.toTypedArray()).build()
        val primitive = frame.primitives.single()
        val covered = primitive.samples(drawing.raster)
        for (y in 0 until drawing.height) {
            for (x in 0 until drawing.width) {
                if (!covered[x, y]) continue
                val depth = primitive.depth(x, y)
                assertTrue(depth >= 0 && depth in primitive.leastDepth..primitive.greatestDepth) {
                    "$depth at $x, $y is outside ${primitive.leastDepth}..${primitive.greatestDepth}"
                }
            }
        }
    }

    @Example
    fun rule_4_4_boundsHoldAtTheVeryEndOfTheRange() {
        // The depth of the plane at the fourth vertex is 2^31-1.01
        val nearer = Depth.toUnit(Depth.FAR - 16_794_010)
        val contour = listOf(
            0.0, 0.0, 1.0,
            1500 / 256.0, -1000 / 256.0, nearer,
            3000 / 256.0, 0.0, 1.0,
            1500 / 256.0, 999 / 256.0, 1.0,
        )
        val builder = FrameBuilder(Raster(16, 16)).polygon(shader, FillRule.NON_ZERO, contour.toDoubleArray())
        val primitive = builder.build().primitives.single()
        assertTrue(primitive.depth(5, 3) in primitive.leastDepth..primitive.greatestDepth) {
            "${primitive.depth(5, 3)} is outside ${primitive.leastDepth}..${primitive.greatestDepth}"
        }
    }

    @Property(seed = "1995", tries = 500, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_5_theReferenceTriangleIsWellApart(
        @ForAll random: Random,
        @ForAll @IntRange(min = 4, max = 9) count: Int,
    ) {
        // Depth of the plane through the three vertices that the contract specifies; the depths of the others do not
        // matter
        val points = List(count) { GridPoint(random.nextInt(6000) - 1000, random.nextInt(6000) - 1000) }
        val first = points[0]
        val distances = points.map { square(it.x - first.x) + square(it.y - first.y) }
        val second = points[distances.indexOf(distances.max())]
        val heights = points.map { Math.abs(it.side(first, second)) }
        val third = points[heights.indexOf(heights.max())]
        for (p in points) {
            val coordinates = Fraction.barycentric(first, second, third, p) ?: return
            assertTrue(coordinates.all { it.abs() <= Fraction(4) }) { "$p has $coordinates in $first, $second, $third" }
        }
        val isReference = { p: GridPoint -> p == first || p == second || p == third }
        val contour = points.flatMap { listOf(it.pixelX, it.pixelY, 0.5 + if (isReference(it)) it.x * 1e-6 else 1e-5) }
        val primitive = FrameBuilder(Raster(16, 16))
            .polygon(shader, FillRule.NON_ZERO, contour.toDoubleArray()).build().primitives.single()
        val form = primitive.depthForm ?: return
        val plane = FrameBuilder(Raster(16, 16)).polygon(
            shader, FillRule.NON_ZERO,
            listOf(first, second, third).flatMap { listOf(it.pixelX, it.pixelY, 0.5 + it.x * 1e-6) }.toDoubleArray(),
        ).build().primitives.single().depthForm ?: return
        assertEquals(plane, form)
    }

    private fun square(n: Int): Long = n.toLong() * n

    @Property(seed = "1995", tries = 300, edgeCases = EdgeCasesMode.NONE)
    fun rule_4_1_theOtherConventionMirrorsDepth(
        @ForAll("drawings") drawing: GridDrawing,
        @ForAll("units") units: List<Double>,
    ) {
        fun frame(convention: DepthConvention): Frame {
            val builder = FrameBuilder(Raster(drawing.width, drawing.height, convention = convention))
            for (contour in drawing.contours) {
                val depths = contour.indices.map { units[it] }
                val triples = contour.flatMapIndexed { i, p -> listOf(p.pixelX, p.pixelY, depths[i]) }
                builder.polygon(shader, FillRule.NON_ZERO, triples.toDoubleArray())
            }
            return builder.build()
        }
        val usual = frame(DepthConvention.SMALLER_IS_NEARER).primitives
        val mirrored = frame(DepthConvention.LARGER_IS_NEARER).primitives
        for ((i, primitive) in usual.withIndex()) {
            val covered = primitive.samples(drawing.raster)
            assertEquals(covered, mirrored[i].samples(drawing.raster))
            for (y in 0 until drawing.height) {
                for (x in 0 until drawing.width) {
                    if (!covered[x, y]) continue
                    val difference = Int.MAX_VALUE - mirrored[i].depth(x, y) - primitive.depth(x, y)
                    assertTrue(Math.abs(difference) <= 1) { "depths differ by $difference at $x, $y" }
                }
            }
        }
    }
}
