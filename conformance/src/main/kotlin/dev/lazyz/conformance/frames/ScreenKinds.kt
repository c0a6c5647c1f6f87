package dev.lazyz.conformance.frames

import dev.lazyz.Depth
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.conformance.frames.screen.Piece
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.conformance.frames.screen.ScreenFrames
import dev.lazyz.conformance.frames.screen.ScreenPolygons
import dev.lazyz.geometry.FillRule
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/**
 * Generates the pieces of each [FrameKind] in screen space, around a raster of at most [maxWidth] x [maxHeight]
 * samples.
 */
internal class ScreenKinds(private val maxWidth: Int, private val maxHeight: Int) {
    private val polygons = ScreenPolygons(maxWidth, maxHeight)

    /** Generates one or more pieces that belong together. */
    fun of(kind: FrameKind): Arbitrary<List<Piece>> = when (kind) {
        FrameKind.SCATTERED -> mixed(2 to outlines(polygons.near), 1 to one(polygons.polygon(polygons.wide())))
        FrameKind.ON_SAMPLES -> outlines(lattice(0.5))
        FrameKind.ON_CORNERS -> outlines(lattice(0.0))
        FrameKind.SLIVERS -> one(polygons.polygon(polygons.sliver()))
        FrameKind.TINY -> one(polygons.polygon(polygons.tiny()))
        FrameKind.CONCAVE -> plates.flatMapPlate { listOf(it.notched()) }
        FrameKind.HOLES -> mixed(2 to plates.flatMapPlate { it.rings() }, 1 to one(polygons.polygon(polygons.holed())))
        FrameKind.COMBS -> combs()
        FrameKind.SELF_CROSSING -> mixed(
            1 to plates.flatMapPlate { listOf(it.bowTie()) },
            1 to plates.flatMapPlate { listOf(it.star()) },
        )
        FrameKind.COINCIDENT -> repeated()
        FrameKind.COPLANAR -> one(polygons.level())
        FrameKind.SHARED_EDGES -> polygons.fan()
        FrameKind.INTERPENETRATING -> plates.map { listOf(it.piece(), it.crossing().piece()) }
        FrameKind.NEARLY_COPLANAR -> nearlyCoplanar()
        FrameKind.TOUCHING -> touching()
        FrameKind.LAYERED -> layers(2, 5)
        FrameKind.GIANT -> mixed(
            2 to one(polygons.polygon(polygons.giant())),
            1 to outlines(polygons.far),
            1 to outlines(mixed(1 to polygons.near, 1 to polygons.far)),
        )
        FrameKind.DEGENERATE -> one(polygons.polygon(polygons.degenerate()))
        FrameKind.CONFETTI -> one(ScreenFrames(maxWidth, maxHeight).confetti())
        else -> throw IllegalArgumentException("$kind is not on the screen")
    }

    /** Generates [min] to [max] plates that cover the whole raster. */
    fun layers(min: Int, max: Int): Arbitrary<List<Piece>> = Combinators.combine(depths, depths)
        .`as` { left, right -> Plate(-1.0, -1.0, maxWidth + 1.0, maxHeight + 1.0, left, right).piece() }
        .list().ofMinSize(min).ofMaxSize(max).map { it }

    private fun combs(): Arbitrary<List<Piece>> = Combinators
        .combine(plates, ints(1, MOST_TEETH), oneOf(2.0, 1.0, 3.0, 1.5)).`as` { plate, teeth, pitch ->
            listOf(plate.comb(teeth.coerceIn(1, maxOf(1, (maxWidth / pitch).toInt())), pitch))
        }
        .flatMapContours()

    private fun nearlyCoplanar(): Arbitrary<List<Piece>> = Combinators
        .combine(depths, depths, ints(1, 64), ints(1, 64), ints(2, 3)).`as` { left, right, nearer, farther, count ->
            listOf(left to right, left - units(nearer) to right + units(farther), left to right + units(farther))
                .take(count)
                .map { (from, to) -> Plate(-1.0, -1.0, maxWidth + 1.0, maxHeight + 1.0, from, to).piece() }
        }

    private fun touching(): Arbitrary<List<Piece>> {
        val corners = Combinators
            .combine(ints(0, maxWidth - 1), ints(1, maxWidth), ints(0, maxHeight), ints(1, maxHeight))
            .`as` { x, width, y, height -> listOf(x / 2 + 0.5, y / 2 + 0.5, x / 2 + width + 0.5, y / 2 + height + 0.5) }
        val levels = Combinators.combine(oneOf(0, 1), ints(-1, 1)).`as` { end, lead -> end to lead }
        return Combinators.combine(corners, depths, depths, levels.list().ofMinSize(1).ofMaxSize(3))
            .`as` { (x0, y0, x1, y1), left, right, list ->
                val slope = Plate(x0, y0, x1, y1, left, right).piece()
                list.map { (end, lead) ->
                    val level = (if (end == 0) left else right) + units(lead)
                    Plate(x0 - 0.5, y0 - 0.5, x1 + 0.5, y1 + 0.5, level, level).piece()
                } + slope
            }
    }

    private fun one(piece: Arbitrary<Piece>): Arbitrary<List<Piece>> = piece.map { listOf(it) }

    private fun outlines(points: Arbitrary<DoubleArray>): Arbitrary<List<Piece>> =
        one(polygons.polygon(polygons.contour(points, 3, 6).map { listOf(it) }))

    /** Generates points at whole pixels, moved by [offset] to the right and down. */
    private fun lattice(offset: Double): Arbitrary<DoubleArray> = Combinators
        .combine(ints(-1, maxWidth), ints(-1, maxHeight), depths)
        .`as` { x, y, depth -> doubleArrayOf(x + offset, y + offset, depth) }

    private fun repeated(): Arbitrary<List<Piece>> {
        val any = mixed(2 to plates.map { listOf<Piece>(it.piece()) }, 1 to polygons.single())
        return Combinators.combine(any, ints(2, 3)).`as` { group, times -> List(times) { group }.flatten() }
    }

    /** Rectangles of at least two pixels on and around the raster. */
    private val plates: Arbitrary<Plate> = Combinators
        .combine(side(maxWidth), side(maxHeight), depths, depths)
        .`as` { x, y, left, right -> Plate(x.first / 2.0, y.first / 2.0, x.last / 2.0, y.last / 2.0, left, right) }

    /** Generates start and end, in half pixels. */
    private fun side(max: Int): Arbitrary<IntRange> = Combinators
        .combine(ints(-2, 2 * max - 2), ints(4, 2 * max + 4))
        .`as` { from, length -> from..from + length }

    private fun Arbitrary<Plate>.flatMapPlate(contours: (Plate) -> List<DoubleArray>): Arbitrary<List<Piece>> =
        map { contours(it) }.flatMapContours()

    private fun Arbitrary<List<DoubleArray>>.flatMapContours(): Arbitrary<List<Piece>> = one(polygons.polygon(this))

    companion object {
        private const val MOST_TEETH = 80

        /** Converts units of depth to a fraction of the distance from near to far. */
        private fun units(count: Int): Double = count / (Depth.FAR.toDouble() - Depth.NEAR)

        /** Depths that are not at the ends of the range, to leave room for a slope. */
        val depths: Arbitrary<Double> = ints(1, 63).map { it / 64.0 }
    }
}

/** A flat rectangle, in pixels, whose depth grows evenly from [left] to [right]. */
internal class Plate(
    private val x0: Double,
    private val y0: Double,
    private val x1: Double,
    private val y1: Double,
    private val left: Double,
    private val right: Double,
) {
    fun piece(): PolygonPiece = PolygonPiece(listOf(outline(0.0 to 0.0, 1.0 to 0.0, 1.0 to 1.0, 0.0 to 1.0)), NON_ZERO)

    /**
     * Returns the same rectangle with the opposite slope and the same depth in the middle; sloped if this one has a
     * constant depth.
     */
    fun crossing(): Plate {
        if (left != right) return Plate(x0, y0, x1, y1, right, left)
        val room = minOf(left, 1.0 - left)
        return Plate(x0, y0, x1, y1, left - room, left + room)
    }

    fun notched(): DoubleArray = outline(0.0 to 0.0, 1.0 to 0.0, 1.0 to 1.0, 0.5 to 0.25, 0.0 to 1.0)

    /**
     * Returns a comb as high as this rectangle, with [teeth] teeth. Each tooth and each gap is half of [pitch] pixels
     * wide.
     */
    fun comb(teeth: Int, pitch: Double): DoubleArray {
        val back = y0 + (y1 - y0) / 4
        val points = arrayListOf(x0 to y0, x0 + teeth * pitch to y0)
        for (i in teeth - 1 downTo 0) {
            val tooth = x0 + i * pitch
            val gap = tooth + pitch / 2
            points.addAll(listOf(gap to back, gap to y1, tooth to y1, tooth to back))
        }
        val length = teeth * pitch
        return points.flatMap { (x, y) -> listOf(x, y, left + (x - x0) / length * (right - left)) }.toDoubleArray()
    }

    /** Returns a frame around a hole, and an island in the hole. */
    fun rings(): List<DoubleArray> = listOf(0.0, 0.25, 0.375).mapIndexed { i, inset ->
        val rest = 1.0 - inset
        if (i == 1) {
            outline(inset to inset, inset to rest, rest to rest, rest to inset)
        } else {
            outline(inset to inset, rest to inset, rest to rest, inset to rest)
        }
    }

    fun bowTie(): DoubleArray = outline(0.0 to 0.0, 1.0 to 1.0, 1.0 to 0.0, 0.0 to 1.0)

    fun star(): DoubleArray = outline(0.5 to 0.0, 0.8125 to 1.0, 0.0 to 0.375, 1.0 to 0.375, 0.1875 to 1.0)

    /** Converts points from fractions of the way from the upper left to the lower right corner. */
    private fun outline(vararg fractions: Pair<Double, Double>): DoubleArray = fractions.flatMap { (x, y) ->
        listOf(x0 + x * (x1 - x0), y0 + y * (y1 - y0), left + x * (right - left))
    }.toDoubleArray()

    private companion object {
        val NON_ZERO = FillRule.NON_ZERO
    }
}
