package dev.lazyz.conformance.oracle

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.conformance.frames.screen.ScreenPolygons
import dev.lazyz.conformance.probes.exact
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.shared.NotByDefault
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.util.Random
import net.jqwik.api.Arbitrary
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Compares primitives made by set-up with exact arithmetic (contract rules 2 to 4). */
class SetUpIsExactTest {
    @Property(tries = 2000, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun everySampleOfASmallRasterIsExact(@ForAll("polygons") polygon: Outline, @ForAll("rasters") raster: Raster) {
        val primitive = polygon.primitive(raster)
        val exact = polygon.exact(raster)
        for (y in 0 until raster.height) {
            val spans = Spans().also { primitive.spans(y, it) }
            for (x in 0 until raster.width) {
                val isCovered = (0 until spans.count).any { x in spans.start(it) until spans.end(it) }
                assertEquals(exact?.covers(x, y) ?: false, isCovered, "coverage at ($x, $y)")
                if (isCovered && exact != null) assertDepth(primitive, exact, x, y)
            }
        }
    }

    @Property(tries = 1000, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun spanEndsOfTheLargestRasterAreExact(@ForAll("largePolygons") polygon: Outline, @ForAll salt: Long) {
        val raster = Raster(Raster.MAX_SIDE, Raster.MAX_SIDE)
        val primitive = polygon.primitive(raster)
        val exact = polygon.exact(raster) ?: return
        val random = Random(salt)
        if (primitive.rowStart >= primitive.rowEnd) return
        repeat(10) {
            val y = primitive.rowStart + random.nextInt(primitive.rowEnd - primitive.rowStart)
            val spans = Spans().also { primitive.spans(y, it) }
            for (i in 0 until spans.count) {
                val start = spans.start(i)
                val end = spans.end(i)
                assertTrue(exact.covers(start, y) && exact.covers(end - 1, y), "inside of $spans in row $y")
                assertTrue(start == 0 || !exact.covers(start - 1, y), "before $spans in row $y")
                assertTrue(end == raster.width || !exact.covers(end, y), "after $spans in row $y")
                val between = start + random.nextInt(end - start)
                for (x in listOf(start, between, end - 1)) assertDepth(primitive, exact, x, y)
            }
        }
    }

    @Property(tries = 200, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    @AddLifecycleHook(NotByDefault::class)
    fun primitivesKeepTheirPromises(@ForAll("frames") case: FrameCase) {
        for (primitive in case.frame.primitives) {
            for (y in 0 until case.frame.height) {
                val spans = Spans().also { primitive.spans(y, it) }
                for (i in 0 until spans.count) {
                    for (x in spans.start(i) until spans.end(i)) assertPromises(primitive, x, y)
                }
            }
        }
    }

    /** Bounds contain all depths, depth equals its linear form, and stepped colours equal those of the sample. */
    private fun assertPromises(primitive: Primitive, x: Int, y: Int) {
        assertTrue(x in primitive.columnStart until primitive.columnEnd, "column $x of $primitive")
        assertTrue(y in primitive.rowStart until primitive.rowEnd, "row $y of $primitive")
        val depth = primitive.depth(x, y)
        assertTrue(depth in primitive.leastDepth..primitive.greatestDepth, "depth $depth of $primitive")
        primitive.depthForm?.let { assertEquals(depth, (it.at(x, y) shr 32).toInt(), "depth of $primitive") }
        val direct = Fragment().also { it.moveTo(x, y) }
        primitive.shade(direct)
        val first = maxOf(primitive.columnStart, x - 3)
        val cursor = primitive.shadingCursor(first, y) ?: return
        repeat(x - first) { cursor.step() }
        val stepped = Fragment().also { it.moveTo(x, y) }
        cursor.shade(stepped)
        assertEquals(direct.toArgb(), stepped.toArgb(), "colour of $primitive at ($x, $y)")
    }

    private fun assertDepth(primitive: Primitive, exact: ExactPolygon, x: Int, y: Int) {
        val depth = primitive.depth(x, y)
        val error = exact.depthError(x, y, depth)
        assertTrue(depth >= 0 && error < 0.8) { "depth $depth at ($x, $y) is $error units off" }
    }

    /** A polygon for both set-up and the oracle. */
    class Outline internal constructor(private val piece: PolygonPiece) {
        fun primitive(raster: Raster): Primitive = FrameBuilder(raster).also {
            piece.addTo(it, 0)
        }.build().primitives[0]

        /** Null for a polygon that covers nothing by rules 9.4 and 9.5. */
        fun exact(raster: Raster): ExactPolygon? {
            val contours = piece.contours
            if (contours.sumOf { it.size } < 9 || contours.any { contour -> contour.any { !it.isFinite() } }) {
                return null
            }
            return piece.exact(raster)
        }

        override fun toString(): String = piece.code(0)
    }

    @Provide
    fun polygons(): Arbitrary<Outline> = outlines(20)

    @Provide
    fun largePolygons(): Arbitrary<Outline> = outlines(Raster.MAX_SIDE)

    @Provide
    fun frames(): Arbitrary<FrameCase> = MixedCases().get()

    @Provide
    fun rasters(): Arbitrary<Raster> = Frames.rasters()

    private fun outlines(side: Int): Arbitrary<Outline> =
        ScreenPolygons(side, side).single().map { Outline(it.single() as PolygonPiece) }
}
