package dev.lazyz.conformance

import dev.lazyz.Camera
import dev.lazyz.FillRule
import dev.lazyz.FrameBuilder
import dev.lazyz.LinearForm
import dev.lazyz.Material
import dev.lazyz.Polygon
import dev.lazyz.Raster
import dev.lazyz.Scene
import dev.lazyz.Surface
import dev.lazyz.Vertex
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/** A primitive on the screen, before it has a number. */
internal sealed interface Piece {
    /** This piece, made to fit a raster. */
    fun on(raster: Raster): Piece = this

    /** Adds this piece to a frame as its primitive [number], which chooses the colour. */
    fun addTo(builder: FrameBuilder, number: Int)

    /** The call that does what [addTo] does. */
    fun code(number: Int): String

    /** What becomes the same primitive before [Camera.screen]; null if a scene file has no words for it. */
    fun surface(number: Int): Surface?
}

/** A polygon as [FrameBuilder.polygon] takes it: x, y in pixels, depth from 0 to 1. */
internal class PolygonPiece(val contours: List<DoubleArray>, val fillRule: FillRule) : Piece {
    override fun addTo(builder: FrameBuilder, number: Int) {
        builder.polygon(Frames.tint(number), fillRule, *contours.toTypedArray())
    }

    override fun code(number: Int): String = contours.joinToString(
        separator = "",
        prefix = ".polygon(Frames.tint($number), FillRule.$fillRule",
        postfix = ")",
    ) { contour -> contour.joinToString(prefix = ", doubleArrayOf(", postfix = ")") { code(it) } }

    override fun surface(number: Int): Surface {
        val vertices = contours.map { contour ->
            (contour.indices step 3).map { Vertex(contour[it], contour[it + 1], contour[it + 2]) }
        }
        return Polygon(vertices, Material(shader = Frames.tint(number), name = "primitive $number"), fillRule)
    }
}

/** [Confetti] that is cut to whatever raster it comes to. */
internal class ConfettiPiece(
    val seed: Int,
    val columns: IntRange,
    val rows: IntRange,
    val levels: Int,
    val form: LinearForm?,
) : Piece {
    override fun on(raster: Raster): Piece = ConfettiPiece(
        seed,
        minOf(columns.first, raster.width)..minOf(columns.last, raster.width),
        minOf(rows.first, raster.height)..minOf(rows.last, raster.height),
        levels,
        form,
    )

    private fun primitive() = Confetti(seed, columns.first, columns.last, rows.first, rows.last, levels, form)

    override fun addTo(builder: FrameBuilder, number: Int) {
        builder.add(primitive())
    }

    override fun code(number: Int): String = ".add(${primitive()})"

    override fun surface(number: Int): Surface? = null
}

/** Makes a frame of [pieces] in this order. */
internal fun screenCase(raster: Raster, pieces: List<Piece>): FrameCase {
    val fitting = pieces.map { it.on(raster) }
    val builder = FrameBuilder(raster)
    fitting.forEachIndexed { number, piece -> piece.addTo(builder, number) }
    val calls = fitting.mapIndexed { number, piece -> "\n    ${piece.code(number)}" }
    val surfaces = fitting.mapIndexedNotNull { number, piece -> piece.surface(number) }
    val scene = if (surfaces.size == fitting.size) Scene(surfaces, viewpoint = Camera.screen()) else null
    return FrameCase(builder.build(), "FrameBuilder(${code(raster)})${calls.joinToString("")}\n    .build()", scene)
}

/** Generates frames of [Piece]s around a raster of at most [maxWidth] x [maxHeight] samples. */
internal class ScreenFrames(private val maxWidth: Int, private val maxHeight: Int) {
    private val polygons = ScreenPolygons(maxWidth, maxHeight)

    fun cases(rasters: Arbitrary<Raster>, max: Int): Arbitrary<FrameCase> {
        val confetti = confetti().map { listOf(it) }
        val all = mixed(6 to polygons.single(), 1 to polygons.twins(), 2 to polygons.fan(), 1 to confetti)
        return frames(rasters, all, max)
    }

    fun tiedCases(rasters: Arbitrary<Raster>, max: Int): Arbitrary<FrameCase> {
        val level = polygons.level().map { listOf(it) }
        val confetti = confetti().map { listOf(it) }
        return frames(rasters, mixed(3 to polygons.twins(), 3 to level, 1 to confetti), max)
    }

    fun confettiCases(rasters: Arbitrary<Raster>, max: Int): Arbitrary<FrameCase> =
        frames(rasters, confetti().map { listOf(it) }, max)

    fun frames(rasters: Arbitrary<Raster>, groups: Arbitrary<List<Piece>>, max: Int): Arbitrary<FrameCase> =
        Combinators.combine(rasters, listsOf(groups, max)).`as` { raster, list ->
            screenCase(raster, list.flatten().take(max))
        }

    fun confetti(): Arbitrary<Piece> {
        val columns = Combinators.combine(ints(0, maxWidth), ints(0, maxWidth))
            .`as` { a, b -> minOf(a, b)..maxOf(a, b) }
        val ordered = Combinators.combine(ints(0, maxHeight), ints(0, maxHeight))
            .`as` { a, b -> minOf(a, b)..maxOf(a, b) }

        // No rows at all may also be said by an end before the start
        val rows = mixed(9 to ordered, 1 to ordered.map { it.last..it.first })
        val levels = oneOf(1, 2, 5, 1000)
        val hashed = Combinators.combine(Arbitraries.integers(), columns, rows, levels)
            .`as` { seed, column, row, level -> ConfettiPiece(seed, column, row, level, null) }
        val longs = Arbitraries.longs()
        val formed = Combinators.combine(Arbitraries.integers(), columns, ordered, longs, longs, longs)
            .`as` { seed, column, row, c, dx, dy -> ConfettiPiece(seed, column, row, 1, LinearForm(c, dx, dy)) }
        return mixed(3 to hashed, 2 to formed)
    }
}
