package dev.lazyz.setup

import dev.lazyz.Fraction
import dev.lazyz.GridPoint
import dev.lazyz.Raster
import dev.lazyz.geometry.FillRule
import dev.lazyz.samples
import dev.lazyz.shading.AttributedPrimitive
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 3.5 and 3.6: attributes, compared with exact perspective-correct interpolation. */
class AttributeProperties {
    @Property(seed = "1995", tries = 2000, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_6_attributesOfTrianglesStayWithinTheirBound(
        @ForAll random: Random,
        @ForAll @IntRange(min = 0, max = 262143) column: Int,
        @ForAll @IntRange(min = 0, max = 262143) row: Int,
    ) {
        val triangle = GuardBandTriangles.around(random, column, row) ?: return
        val ws = List(3) { StrictMath.pow(2.0, random.nextDouble() * random.nextInt(12)) }
        val values = List(3) {
            if (random.nextInt(4) == 0) random.nextInt(3).toDouble() else random.nextDouble() * 2 - 1
        }
        val primitive = primitive(Raster(262144, 262144), triangle, ws, values) ?: return
        val corners = triangle.indices.map { Corner(triangle[it], ws[it], values[it]) }
        check(primitive, corners, GridPoint(column, row)) { TRIANGLE * greatest(values) }
    }

    @Property(seed = "1995", tries = 300, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_6_attributesOfPolygonsStayWithinTheirBound(
        @ForAll random: Random,
        @ForAll @IntRange(max = 12) depth: Int,
    ) {
        // A flat polygon in perspective: 1/w and value/w are linear on the screen
        val points = List(4 + random.nextInt(5)) { GridPoint(random.nextInt(8192) - 2048, random.nextInt(8192) - 2048) }
        val tilt = List(4) { random.nextDouble() * 2 - 1 }
        val slant = points.map { tilt[0] * it.x + tilt[1] * it.y }
        val nearest = slant.min() - (slant.max() - slant.min()) * StrictMath.pow(2.0, -depth.toDouble()) - 1e-3
        val ws = slant.map { 1.0 / (it - nearest) }
        val values = points.mapIndexed { i, p -> (tilt[2] * p.x + tilt[3] * p.y) * ws[i] }
        val raster = Raster(16, 16)
        val primitive = primitive(raster, points, ws, values) ?: return
        val covered = primitive.samples(raster)
        val reference = referenceOf(points)
        for (y in 0 until 16) {
            for (x in 0 until 16) {
                if (!covered[x, y] || random.nextInt(8) > 0) continue
                val corners = reference.map { Corner(points[it], ws[it], values[it]) }
                check(primitive, corners, GridPoint(x, y)) { w ->
                    val ratio = w / ws.min()
                    POLYGON * greatest(values) * ratio * ratio
                }
            }
        }
    }

    /**
     * The reference triangle as the contract defines it: first, farthest from it, farthest from the line through both.
     */
    private fun referenceOf(points: List<GridPoint>): List<Int> {
        val first = points[0]
        val distances = points.map { square(it.x - first.x) + square(it.y - first.y) }
        val second = distances.indexOf(distances.max())
        val heights = points.map { Math.abs(it.side(first, points[second])) }
        return listOf(0, second, heights.indexOf(heights.max()))
    }

    private fun square(n: Int): Long = n.toLong() * n

    private class Corner(val point: GridPoint, val w: Double, val value: Double)

    private fun greatest(values: List<Double>): Double = values.maxOf { Math.abs(it) }

    /**
     * Compares the attribute at [pixel] with the exact one; [bound] is the error bound of w, before rounding to single
     * precision.
     */
    private fun check(
        primitive: AttributedPrimitive,
        corners: List<Corner>,
        pixel: GridPoint,
        bound: (w: Double) -> Double,
    ) {
        val sample = GridPoint(256 * pixel.x + 128, 256 * pixel.y + 128)
        val (a, b, c) = corners.map { it.point }
        val coordinates = Fraction.barycentric(a, b, c, sample) ?: return
        val over = coordinates.zip(corners) { weight, corner -> weight / Fraction.of(corner.w) }
        val top = over.zip(corners) { weight, corner -> weight * Fraction.of(corner.value) }
        val exact = Fraction.sum(top) / Fraction.sum(over)
        val sampleW = 1.0 / Fraction.sum(over).toDouble()

        val fragment = Fragment()
        fragment.moveTo(pixel.x, pixel.y)
        primitive.attributes(fragment)
        val error = (Fraction.of(fragment.u.toDouble()) - exact).abs().toDouble()
        val most = bound(sampleW) + Math.ulp(exact.toDouble().toFloat()) / 2
        assertTrue(error <= most) { "off by $error, more than $most at $pixel: ${corners.map { it.point }}" }
    }

    private fun primitive(
        raster: Raster,
        points: List<GridPoint>,
        ws: List<Double>,
        values: List<Double>,
    ): AttributedPrimitive? {
        val vertices = Vertices(points.size)
        for (i in points.indices) {
            vertices.set(i, Vertices.W, ws[i])
            vertices.set(i, Vertices.UV, values[i])
        }
        val all = IntArray(points.size) { it }
        val assembly = PrimitiveAssembly(
            vertices, all, intArrayOf(points.size),
            IntArray(points.size) { points[it].x },
            IntArray(points.size) { points[it].y },
            IntArray(points.size) { 1 shl 30 },
        )
        return assembly.primitive(raster, FillRule.NON_ZERO, Shader { }, Attributes.UV, 1.0, isTranslucent = false)
    }

    private companion object {
        /** Relative to the greatest value: eight roundings of double precision. */
        const val TRIANGLE = 1.0 / (1L shl 49)

        /** If weights can be negative: to be multiplied by the square of w over the smallest w. */
        const val POLYGON = 1.0 / (1L shl 44)
    }
}
