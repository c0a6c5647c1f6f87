package dev.lazyz.conformance.oracle

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Spans
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.fail
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Compares set-up with integer arithmetic, for all polygons on a small lattice: contract rules 2.1 to 2.5. */
class SmallLatticeTest {
    private val shader = Shader { it.setColor(1f, 1f, 1f, 1f) }
    private val spans = Spans()

    /** All triangles except for rotations, in both orientations, on half pixels in and around 2 x 2 samples. */
    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun everyTriangleOnHalfPixelsIsExact() {
        val lattice = SmallLattice(from = -128, step = 128, side = 7, raster = 2)
        assertEquals((49 * 49 * 49 + 2 * 49) / 3, triangles(lattice))
    }

    /** The same on about thirds of a pixel, where edges rarely meet samples, around 3 x 3 samples. */
    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun everyTriangleOnACrookedLatticeIsExact() {
        triangles(SmallLattice(from = -43, step = 107, side = 8, raster = 3))
    }

    /** Tests all triangles of [lattice] and returns their number. */
    private fun triangles(lattice: SmallLattice): Int {
        val raster = Raster(lattice.raster, lattice.raster)
        var count = 0
        for (a in 0 until lattice.points) {
            for (b in a until lattice.points) {
                // The first vertex is the least: that is one of the three rotations
                for (c in a until lattice.points) {
                    if (c == a && b != a) continue
                    count++
                    val mask = mask(primitive(lattice, raster, FillRule.NON_ZERO, a, b, c), lattice.raster)
                    val expected = lattice.triangle(a, b, c)
                    if (mask != expected) wrong(lattice, mask, expected, a, b, c)
                    if (count % 61 == 0) assertEquals(expected, exactMask(lattice, FillRule.NON_ZERO, a, b, c))
                }
            }
        }
        return count
    }

    /** All pairs of triangles on the two sides of an edge: no sample is covered twice, and none is missed. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun everyPairAtASharedEdgeCoversEachSampleOnce() {
        val lattice = SmallLattice(from = 0, step = 64, side = 9, raster = 2)
        val raster = Raster(lattice.raster, lattice.raster)
        val n = lattice.points
        val masks = ByteArray(n * n * n)
        for (a in 0 until n) {
            for (b in 0 until n) {
                for (c in 0 until n) {
                    val primitive = primitive(lattice, raster, FillRule.NON_ZERO, a, b, c)
                    masks[(a * n + b) * n + c] = mask(primitive, lattice.raster).toByte()
                }
            }
        }
        var count = 0
        for (a in 0 until n) {
            for (b in a + 1 until n) {
                val left = (0 until n).filter { lattice.area(a, b, it) > 0 }
                val right = (0 until n).filter { lattice.area(a, b, it) < 0 }
                for (c in left) {
                    val one = masks[(a * n + b) * n + c].toInt()
                    for (d in right) {
                        // The adjacent triangle has the edge in the other direction
                        val other = masks[(b * n + a) * n + d].toInt()
                        count++
                        if (one and other != 0) wrong(lattice, one, other, a, b, c, d)
                        if (count % 7 != 0) continue
                        val both = lattice.windings(intArrayOf(a, d, b, c)) { it != 0 }
                        if (one or other != both) wrong(lattice, one or other, both, a, d, b, c)
                    }
                }
            }
        }
        assertEquals(3_521_912, count)
    }

    /** All quadrilaterals except for rotations, including self-intersecting and flat ones, with both fill rules. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun everyQuadrilateralOnHalfPixelsIsExact() {
        val lattice = SmallLattice(from = -128, step = 128, side = 6, raster = 2)
        val raster = Raster(lattice.raster, lattice.raster)
        var count = 0
        for (rule in FillRule.entries) {
            val isInside: (Int) -> Boolean = if (rule == FillRule.EVEN_ODD) ({ it % 2 != 0 }) else ({ it != 0 })
            for (a in 0 until lattice.points) {
                for (b in a until lattice.points) {
                    for (c in a until lattice.points) {
                        for (d in a until lattice.points) {
                            count++
                            val quad = intArrayOf(a, b, c, d)
                            val mask = mask(primitive(lattice, raster, rule, *quad), lattice.raster)
                            val expected = lattice.windings(quad, isInside)
                            if (mask != expected) wrong(lattice, mask, expected, *quad)
                            if (count % 61 == 0) assertEquals(expected, exactMask(lattice, rule, *quad))
                        }
                    }
                }
            }
        }
        assertEquals(887_112, count)
    }

    private fun primitive(lattice: SmallLattice, raster: Raster, rule: FillRule, vararg points: Int): Primitive {
        val contour = DoubleArray(3 * points.size) {
            when (it % 3) {
                0 -> lattice.x(points[it / 3]) / 256.0
                1 -> lattice.y(points[it / 3]) / 256.0
                else -> 0.5
            }
        }
        return FrameBuilder(raster).polygon(shader, rule, contour).build().primitives[0]
    }

    private fun mask(primitive: Primitive, side: Int): Int {
        var bits = 0
        for (y in 0 until side) {
            spans.clear()
            primitive.spans(y, spans)
            for (i in 0 until spans.count) {
                for (x in spans.start(i) until spans.end(i)) bits = bits or (1 shl (y * side + x))
            }
        }
        return bits
    }

    private fun exactMask(lattice: SmallLattice, rule: FillRule, vararg points: Int): Int {
        val exact = ExactPolygon(listOf(points.flatMap { listOf(lattice.x(it), lattice.y(it), 0) }.toIntArray()), rule)
        return (0 until lattice.raster * lattice.raster)
            .filter { exact.covers(it % lattice.raster, it / lattice.raster) }
            .fold(0) { bits, it -> bits or (1 shl it) }
    }

    private fun wrong(lattice: SmallLattice, mask: Int, expected: Int, vararg points: Int): Nothing = fail(
        "samples ${mask.toString(2)} instead of ${expected.toString(2)} of " +
            points.joinToString { "(${lattice.x(it) / 256.0}, ${lattice.y(it) / 256.0})" },
    )
}
