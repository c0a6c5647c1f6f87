package dev.lazyz.conformance.frames.screen

import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.geometry.FillRule
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/** Generates polygons around a raster of at most [maxWidth] x [maxHeight] samples, in pixels. */
internal class ScreenPolygons(private val maxWidth: Int, private val maxHeight: Int) {
    private val fillRules = oneOf(FillRule.NON_ZERO, FillRule.EVEN_ODD)

    /** Points anywhere on the grid, on the raster and up to an eighth of its size around it. */
    val near = points(grid(maxWidth), grid(maxHeight), depths)

    /** Points on samples and pixel corners. */
    val aligned = points(halves(maxWidth), halves(maxHeight), depths)

    private val either = mixed(1 to near, 1 to aligned)

    /** Points up to the limit of the guard band. */
    val far = points(guard, guard, depths)

    /** Generates one polygon of any kind. */
    fun single(): Arbitrary<List<Piece>> = mixed(
        3 to polygon(contour(near, 3, 6).map { listOf(it) }),
        3 to polygon(contour(aligned, 3, 6).map { listOf(it) }),
        8 to polygon(wide()),
        1 to polygon(giant()),
        1 to polygon(contour(mixed(1 to near, 1 to far), 3, 5).map { listOf(it) }),
        1 to polygon(tiny()),
        1 to polygon(sliver()),
        2 to polygon(holed()),
        2 to level(),
        1 to polygon(degenerate()),
    ).map { listOf(it) }

    /** Generates the same polygon twice. */
    fun twins(): Arbitrary<List<Piece>> = single().map { it + it }

    /** Generates a polygon with one of a few constant depths, coplanar with many others. */
    fun level(): Arbitrary<Piece> {
        val outlines = mixed(1 to contour(either, 3, 6), 1 to wide().map { it.single() })
        val levels = oneOf(0.5, 0.25, 0.75, 0.0, 1.0)
        val contours = Combinators.combine(outlines, levels).`as` { outline, level ->
            listOf(DoubleArray(outline.size) { if (it % 3 == 2) level else outline[it] })
        }
        return polygon(contours)
    }

    /** Generates triangles around a point, each of which shares an edge with the next. Some overlap. */
    fun fan(): Arbitrary<List<Piece>> = Combinators
        .combine(either, either.list().ofMinSize(3).ofMaxSize(5))
        .`as` { center, ring ->
            ring.indices.map {
                PolygonPiece(listOf(center + ring[it] + ring[(it + 1) % ring.size]), FillRule.NON_ZERO)
            }
        }

    fun polygon(contours: Arbitrary<List<DoubleArray>>): Arbitrary<Piece> =
        Combinators.combine(contours, fillRules).`as` { list, rule -> PolygonPiece(list, rule) }

    fun contour(points: Arbitrary<DoubleArray>, min: Int, max: Int): Arbitrary<DoubleArray> =
        points.list().ofMinSize(min).ofMaxSize(max).map { list -> list.reduce { all, point -> all + point } }

    /** Generates polygons with four or three corners, each in its quadrant of the raster or slightly outside of it. */
    fun wide(): Arbitrary<List<DoubleArray>> {
        fun along(side: Int, end: Int) = Combinators.combine(ints(-16, 48), oneOf(2.0, 256.0)).`as` { part, steps ->
            val inset = StrictMath.rint(part * side * steps / 128) / steps
            if (end == 0) inset else side - inset
        }
        fun corner(right: Int, down: Int) = points(along(maxWidth, right), along(maxHeight, down), depths)
        return Combinators.combine(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1), ints(0, 7))
            .`as` { a, b, c, d, dropped ->
                listOf(listOf(a, b, c, d).filterIndexed { i, _ -> i != dropped }.reduce { all, point -> all + point })
            }
    }

    /**
     * Generates polygons with a vertex in each quadrant, up to the limit of the guard band: around most of the raster,
     * or all of it.
     */
    fun giant(): Arbitrary<List<DoubleArray>> = far.list().ofSize(4).map { vertices ->
        val contour = vertices.mapIndexed { i, (x, y, depth) ->
            val (right, down) = listOf(-1 to -1, 1 to -1, 1 to 1, -1 to 1)[i]
            doubleArrayOf(right * StrictMath.abs(x), down * StrictMath.abs(y), depth)
        }
        listOf(contour.reduce { all, point -> all + point })
    }

    /** Generates polygons within about two pixels of a point, which cover one or two samples, or none. */
    fun tiny(): Arbitrary<List<DoubleArray>> = Combinators
        .combine(near, contour(points(ints(-500, 500).map(::pixels), ints(-500, 500).map(::pixels), depths), 3, 4))
        .`as` { at, around ->
            listOf(DoubleArray(around.size) { if (it % 3 == 2) around[it] else at[it % 3] + around[it] })
        }

    /**
     * Generates triangles a few grid steps wide and of any length, with any depths, so that they are steep. Most
     * contain a row of samples.
     */
    fun sliver(): Arbitrary<List<DoubleArray>> = mixed(1 to anySliver(), 3 to sliverAroundSamples())

    private fun sliverAroundSamples(): Arbitrary<List<DoubleArray>> {
        val samples = points(ints(0, maxWidth - 1).map { it + 0.5 }, ints(0, maxHeight - 1).map { it + 0.5 }, depths)
        val ways = Combinators.combine(ints(0, 3), ints(-3, 3), ints(1, minOf(maxOf(maxWidth, maxHeight), LONGEST)))
            .`as` { right, down, times -> times * (if (right == 0 && down == 0) 1 else right) to times * down }
        return Combinators.combine(samples, ways, ints(1, 3), ints(-3, 3), depths).`as` { at, way, dx, dy, depth ->
            val (right, down) = way

            // Half the width, never along the sliver, so that the samples on the way are inside
            val isAlong = right * dy == down * dx
            val x = pixels(dx)
            val y = if (isAlong) pixels(if (dy > 0) dy - 1 else dy + 1) else pixels(dy)
            listOf(
                doubleArrayOf(
                    at[0] - x, at[1] - y, at[2], at[0] + right, at[1] + down, depth, at[0] + x, at[1] + y, 1 - at[2],
                ),
            )
        }
    }

    private fun anySliver(): Arbitrary<List<DoubleArray>> = Combinators
        .combine(near, mixed(1 to near, 1 to aligned, 1 to far), ints(-3, 3), ints(-3, 3), depths)
        .`as` { a, b, dx, dy, depth ->
            val third = doubleArrayOf((b[0] + pixels(dx)).coerceIn(BAND), (b[1] + pixels(dy)).coerceIn(BAND), depth)
            listOf(a + b + third)
        }

    /** Generates two or three contours: nested, touching or intersecting, with either winding. */
    fun holed(): Arbitrary<List<DoubleArray>> {
        val box = Combinators.combine(aligned, aligned, oneOf(true, false)).`as` { a, b, isTurned ->
            val other = if (isTurned) doubleArrayOf(a[0], b[1], a[2]) else doubleArrayOf(b[0], a[1], a[2])
            val fourth = if (isTurned) doubleArrayOf(b[0], a[1], b[2]) else doubleArrayOf(a[0], b[1], b[2])
            a + other + b + fourth
        }
        return mixed(1 to box, 1 to contour(near, 3, 4)).list().ofMinSize(2).ofMaxSize(3)
    }

    /** Generates polygons that cover nothing: too few vertices, no area, NaN or infinite numbers. */
    fun degenerate(): Arbitrary<List<DoubleArray>> {
        val empty = Arbitraries.just(emptyList<DoubleArray>())
        val few = contour(near, 1, 2).map { listOf(it) }
        val flat = Combinators.combine(aligned, aligned).`as` { a, b -> listOf(a + b + a + b) }
        val awkward = oneOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)
        val unreal = Combinators.combine(contour(near, 3, 4), awkward, ints(0, 8)).`as` { contour, value, at ->
            listOf(contour.copyOf().also { it[at] = value })
        }
        return mixed(1 to empty, 1 to few, 1 to flat, 1 to unreal)
    }

    companion object {
        /** Three times this distance beyond the largest raster is still within the guard band. */
        private const val LONGEST = 65_536

        /** The guard band. */
        val BAND = -524288.0..524288.0

        /** Depths from near to far, in steps that a double represents exactly. */
        val depths: Arbitrary<Double> = mixed(1 to ints(0, 1024).map { it / 1024.0 }, 1 to oneOf(0.5, 0.0, 1.0))

        /** Coordinates up to the limit of the guard band, often the limit itself. */
        private val guard: Arbitrary<Double> = mixed(
            3 to ints(-(1 shl 27), 1 shl 27).map(::pixels),
            1 to oneOf(BAND.start, BAND.endInclusive),
        )

        private fun pixels(gridSteps: Int): Double = gridSteps / 256.0

        private fun grid(side: Int): Arbitrary<Double> = ints(-32 * side, 288 * side).map(::pixels)

        fun halves(side: Int): Arbitrary<Double> = ints(-2, 2 * side + 2).map { it / 2.0 }

        fun points(xs: Arbitrary<Double>, ys: Arbitrary<Double>, depths: Arbitrary<Double>): Arbitrary<DoubleArray> =
            Combinators.combine(xs, ys, depths).`as` { x, y, depth -> doubleArrayOf(x, y, depth) }
    }
}
