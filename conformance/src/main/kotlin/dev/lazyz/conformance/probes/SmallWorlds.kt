package dev.lazyz.conformance.probes

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.conformance.frames.screen.screenCase
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.oracle.ExactPolygon
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder

/**
 * Tests [renderer] with every ordered pair of a few dozen shapes on a raster of 3 x 2 samples, with all four depth
 * tests and both conventions: about ten thousand pictures, all combinations of these shapes.
 *
 * The pairs include a shape with itself. The shapes are rectangles on a half-pixel lattice, triangles of both
 * orientations, a concave shape and a hole, at two constant depths and on slopes that intersect them and each other at
 * samples, between samples, and nowhere. [ExactPolygon] decides which samples a shape covers, not the primitive. The
 * depth is the primitive's, after a check that it is within one unit of the exact one.
 *
 * @throws AssertionError for the first picture that is wrong
 */
internal fun smallWorlds(renderer: Renderer) {
    for (convention in DepthConvention.entries) {
        for (test in DepthTest.entries) {
            val behind = Rasters.behindAll(test)
            SmallWorld(Raster(3, 2, Rgba.WHITE, convention, test, behind)).judge(renderer)
        }
    }
}

/** All ordered pairs of shapes on one raster. */
internal class SmallWorld(private val raster: Raster) {
    private val size = raster.width * raster.height
    private val shapes = pieces.map { Shape(it) }

    /** Number of pictures. */
    val pictures: Int get() = shapes.size * shapes.size

    /**
     * Returns in how many pictures the depths of the two shapes are equal at a sample, and in how many their order
     * changes.
     */
    fun ties(): Pair<Int, Int> {
        val pairs = shapes.flatMap { a -> shapes.map { b -> signs(a, b) } }
        return Pair(pairs.count { 0 in it }, pairs.count { 1 in it && -1 in it })
    }

    private fun signs(a: Shape, b: Shape): Set<Int> =
        (0 until size).filter { a.isCovered[it] && b.isCovered[it] }.map { a.depth[it].compareTo(b.depth[it]) }.toSet()

    /** Fails at the first picture that [renderer] renders incorrectly. */
    fun judge(renderer: Renderer) {
        for (first in shapes) {
            for (second in shapes) {
                val frame = FrameBuilder(raster).add(first.primitive).add(second.primitive).build()
                val picture = try {
                    TryUnderWay.current?.goesOn()
                    renderer.render(frame)
                } catch (e: Exception) {
                    fail(renderer, first, second, "threw $e", e)
                }
                val sample = wrongSample(picture, first, second)
                if (sample >= 0) fail(renderer, first, second, report(picture, sample), null)
            }
        }
    }

    private fun wrongSample(picture: Image, first: Shape, second: Shape): Int {
        for (i in 0 until size) {
            val winner = winner(i, first, second)
            val depth = when (winner) {
                DepthTest.BACKGROUND -> raster.backgroundDepth
                0 -> first.depth[i]
                else -> second.depth[i]
            }
            if (picture.primitive[i] != winner || picture.depth[i] != depth) return i
        }
        return -1
    }

    /** Rules 5.1 to 5.3, for two primitives. */
    private fun winner(sample: Int, first: Shape, second: Shape): Int {
        if (!first.isCovered[sample]) return if (second.isCovered[sample]) 1 else DepthTest.BACKGROUND
        if (!second.isCovered[sample]) return 0
        val order = first.depth[sample].compareTo(second.depth[sample])
        return when (raster.depthTest) {
            DepthTest.LESS -> if (order <= 0) 0 else 1
            DepthTest.LESS_OR_EQUAL -> if (order < 0) 0 else 1
            DepthTest.GREATER -> if (order >= 0) 0 else 1
            DepthTest.GREATER_OR_EQUAL -> if (order > 0) 0 else 1
        }
    }

    private fun report(picture: Image, sample: Int): String =
        "sample (${sample % raster.width}, ${sample / raster.width}) of a small world shows primitive " +
            "${picture.primitive[sample]} at depth ${picture.depth[sample]}"

    private fun fail(renderer: Renderer, first: Shape, second: Shape, what: String, cause: Throwable?): Nothing {
        val case = screenCase(raster, listOf(first.piece, second.piece))

        // Prefer the message of the usual comparison. It may find no difference, because it trusts primitives
        Judgement(renderer, case).equalsReference()
        throw AssertionError("${renderer.id}: $what\nin\n$case", cause)
    }

    /** A shape with its exact coverage and depth on this raster. */
    private inner class Shape(val piece: PolygonPiece) {
        val primitive: Primitive = FrameBuilder(raster).also { piece.addTo(it, 0) }.build().primitives[0]
        private val exact = piece.exact(raster)
        val isCovered = BooleanArray(size) { exact.covers(it % raster.width, it / raster.width) }
        val depth = IntArray(size) { if (isCovered[it]) primitive.depth(it % raster.width, it / raster.width) else -1 }

        init {
            for (i in 0 until size) {
                if (!isCovered[i]) continue
                val error = exact.depthError(i % raster.width, i / raster.width, depth[i])
                check(error <= 1.0) { "the depth of set-up is wrong by $error units at sample $i of ${piece.code(0)}" }
            }
        }
    }

    internal companion object {
        /** Depth at the left and the right border of the raster: constant depths, and slopes that intersect them. */
        private val slopes = listOf(0.5 to 0.5, 0.25 to 0.25, 0.25 to 0.75, 0.75 to 0.25, 0.5 to 0.75)

        /** Outlines on a half-pixel lattice, so that most have samples on their edges: x, y pairs. */
        private val outlines = listOf(
            listOf(doubleArrayOf(0.0, 0.0, 3.0, 0.0, 3.0, 2.0, 0.0, 2.0)),
            listOf(doubleArrayOf(0.5, 0.5, 2.5, 0.5, 2.5, 1.5, 0.5, 1.5)),
            listOf(doubleArrayOf(1.0, 0.0, 2.0, 0.0, 2.0, 2.0, 1.0, 2.0)),
            listOf(doubleArrayOf(0.0, 1.0, 3.0, 1.0, 3.0, 2.0, 0.0, 2.0)),
            listOf(doubleArrayOf(-0.5, -0.5, 3.5, -0.5, -0.5, 2.5)),
            listOf(doubleArrayOf(3.5, 2.5, 3.5, -0.5, -0.5, 2.5)),
            listOf(doubleArrayOf(0.0, 0.0, 3.0, 0.0, 3.0, 2.0, 1.5, 0.5, 0.0, 2.0)),
            listOf(
                doubleArrayOf(0.0, 0.0, 3.0, 0.0, 3.0, 2.0, 0.0, 2.0),
                doubleArrayOf(1.0, 0.0, 2.0, 0.0, 2.0, 1.0, 1.0, 1.0),
            ),
        )

        private val pieces: List<PolygonPiece> = outlines.flatMap { outline ->
            slopes.map { (left, right) -> PolygonPiece(outline.map { sloped(it, left, right) }, FillRule.EVEN_ODD) }
        }

        private fun sloped(outline: DoubleArray, left: Double, right: Double): DoubleArray =
            (0 until outline.size / 2).flatMap { i ->
                val x = outline[2 * i]
                listOf(x, outline[2 * i + 1], left + (right - left) * (x + 1.0) / 5.0)
            }.toDoubleArray()
    }
}

/**
 * Returns this polygon snapped by rules 1.3 and 4.2, without set-up. Its numbers must be finite exact multiples of the
 * grid.
 */
internal fun PolygonPiece.exact(raster: Raster): ExactPolygon {
    val isMirrored = raster.convention == DepthConvention.LARGER_IS_NEARER
    val snapped = contours.map { contour ->
        IntArray(contour.size) {
            val depth = Depth.ofUnit(contour[it])
            if (it % 3 == 2) if (isMirrored) Int.MAX_VALUE - depth else depth else (contour[it] * 256).toInt()
        }
    }
    return ExactPolygon(snapped, fillRule)
}
