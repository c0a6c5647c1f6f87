package dev.lazyz.conformance.frames.screen

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.code
import dev.lazyz.geometry.FillRule
import dev.lazyz.scenes.Tint
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.LinearForm
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface

/** A primitive in screen space, before it has an index. */
internal sealed interface Piece {
    /** Returns this piece, fitted to a raster. */
    fun on(raster: Raster): Piece = this

    /** Returns this piece moved by the given number of pixels. */
    fun moved(right: Int, down: Int): Piece

    /** Adds this piece to a frame as its primitive [number]. The number determines the colour. */
    fun addTo(builder: FrameBuilder, number: Int)

    /** Returns the code of the call that [addTo] makes. */
    fun code(number: Int): String

    /**
     * Returns the surface that becomes the same primitive with [Camera.screen]; null if a scene file cannot express it.
     */
    fun surface(number: Int): Surface?
}

/** A polygon with the arguments of [FrameBuilder.polygon]: x, y in pixels, depth from 0 to 1. */
internal class PolygonPiece(val contours: List<DoubleArray>, val fillRule: FillRule) : Piece {
    override fun moved(right: Int, down: Int): PolygonPiece {
        val by = doubleArrayOf(right.toDouble(), down.toDouble(), 0.0)
        return PolygonPiece(
            contours.map { contour ->
                DoubleArray(contour.size) { contour[it] + by[it % 3] }
            },
            fillRule
        )
    }

    override fun addTo(builder: FrameBuilder, number: Int) {
        builder.polygon(Tint(number), fillRule, *contours.toTypedArray())
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
        return Polygon(vertices, Material(shader = Tint(number), name = "primitive $number"), fillRule)
    }
}

/** [Confetti] that is clipped to its raster. */
internal class ConfettiPiece(
    val seed: Int,
    val columns: IntRange,
    val rows: IntRange,
    val levels: Int,
    val form: LinearForm?,
) : Piece {
    override fun on(raster: Raster): Piece =
        ConfettiPiece(seed, within(columns, raster.width), within(rows, raster.height), levels, form)

    override fun moved(right: Int, down: Int): Piece = ConfettiPiece(
        seed,
        columns.first + right..columns.last + right,
        rows.first + down..rows.last + down,
        levels,
        form,
    )

    /** Moves [range] so that it starts within [length] samples, and clips its end. */
    private fun within(range: IntRange, length: Int): IntRange {
        val off = range.first / length * length
        return minOf(range.first - off, length)..minOf(range.last - off, length)
    }

    private fun primitive() = Confetti(seed, columns.first, columns.last, rows.first, rows.last, levels, form)

    override fun addTo(builder: FrameBuilder, number: Int) {
        builder.add(primitive())
    }

    override fun code(number: Int): String = ".add(${primitive()})"

    override fun surface(number: Int): Surface? = null
}

/** Returns this group moved by the given number of pixels; unchanged if it would leave the guard band. */
internal fun List<Piece>.moved(right: Int, down: Int): List<Piece> {
    if (right == 0 && down == 0) return this
    val reach = ScreenPolygons.BAND.endInclusive - maxOf(StrictMath.abs(right), StrictMath.abs(down))
    val isFar = any { piece ->
        piece is PolygonPiece && piece.contours.any { contour -> contour.any { !(StrictMath.abs(it) <= reach) } }
    }
    return if (isFar) this else map { it.moved(right, down) }
}

/**
 * Returns this group moved by multiples of the raster's size until its centre is on [raster]; unchanged if it reaches
 * very far.
 */
internal fun List<Piece>.broughtTo(raster: Raster): List<Piece> {
    val contours = filterIsInstance<PolygonPiece>().flatMap { it.contours }.filter { it.isNotEmpty() }
    if (contours.isEmpty()) return this
    fun shift(axis: Int, length: Int): Int {
        val values = contours.flatMap { contour -> (axis until contour.size step 3).map { contour[it] } }
        if (values.any { !(StrictMath.abs(it) <= FAR_OFF) }) return 0
        val middle = (values.min() + values.max()) / 2
        return -StrictMath.floor(middle / length).toInt() * length
    }
    val (polygons, others) = partition { it is PolygonPiece }
    return polygons.moved(shift(0, raster.width), shift(1, raster.height)) + others
}

/** In pixels: half the distance to the limit of the guard band. */
private const val FAR_OFF = 262144.0

/** The order of the pieces of several groups in a frame. */
internal enum class PieceOrder {
    /** Group by group. */
    TOGETHER,

    /** The first of each group, then the second of each, so that primitives that tie are far apart. */
    APART,
    ;

    fun of(groups: List<List<Piece>>): List<Piece> = when (this) {
        TOGETHER -> groups.flatten()
        APART -> (0 until (groups.maxOfOrNull { it.size } ?: 0)).flatMap { i -> groups.mapNotNull { it.getOrNull(i) } }
    }
}

/** Creates a frame of [pieces] in this order. */
internal fun screenCase(raster: Raster, pieces: List<Piece>): FrameCase {
    val fitting = pieces.map { it.on(raster) }
    val builder = FrameBuilder(raster)
    fitting.forEachIndexed { number, piece -> piece.addTo(builder, number) }
    val calls = fitting.mapIndexed { number, piece -> "\n    ${piece.code(number)}" }
    val surfaces = fitting.mapIndexedNotNull { number, piece -> piece.surface(number) }
    val scene = if (surfaces.size == fitting.size) Scene(surfaces, viewpoint = Camera.screen()) else null
    return FrameCase(builder.build(), "FrameBuilder(${code(raster)})${calls.joinToString("")}\n    .build()", scene)
}
