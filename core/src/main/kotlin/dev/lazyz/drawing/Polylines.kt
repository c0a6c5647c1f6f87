package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.drawing.EdgeDrawing.LineKind
import dev.lazyz.geometry.DistinctTriples
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Joins [pieces] to polylines: at a point where exactly two pieces end, they are parts of one polyline. Used once; not
 * thread safe. Cost: linear.
 *
 * @param pointCount number of points of the model
 */
internal class Polylines(private val pieces: Pieces, pointCount: Int) {
    /** By point: twice the number of a piece, plus the end that is there; -1 if there is none. */
    private val first = IntArray(pointCount) { -1 }
    private val second = IntArray(pointCount) { -1 }
    private val isUsed = BooleanArray(pieces.count)

    init {
        for (i in 0 until 2 * pieces.count) {
            val point = pieces.point(i / 2, i % 2)
            if (point < 0) continue
            when {
                first[point] == -1 -> first[point] = i
                second[point] == -1 -> second[point] = i
                else -> second[point] = CROWD
            }
        }
    }

    /** Calls [action] with the columns and rows of the points of each polyline, x and y in turn, pixels. */
    fun forEach(action: (DoubleArray) -> Unit) {
        // Those with two ends come first; the others are closed
        for (i in 0 until 2 * pieces.count) if (!isUsed[i / 2] && partner(i) < 0) action(from(i))
        for (i in 0 until pieces.count) if (!isUsed[i]) action(from(2 * i))
    }

    /** Returns the end of another piece that continues the end [i] of a piece, or -1. */
    private fun partner(i: Int): Int {
        val point = pieces.point(i / 2, i % 2)
        if (point < 0 || second[point] < 0) return -1
        return if (first[point] == i) second[point] else first[point]
    }

    private fun from(start: Int): DoubleArray {
        var places = DoubleArray(16)
        var size = 0
        fun add(x: Double, y: Double) {
            if (size == places.size) places = places.copyOf(2 * size)
            places[size++] = x
            places[size++] = y
        }
        add(pieces.x(start / 2, start % 2), pieces.y(start / 2, start % 2))
        var at = start
        while (at >= 0 && !isUsed[at / 2]) {
            isUsed[at / 2] = true
            val other = at xor 1
            add(pieces.x(other / 2, other % 2), pieces.y(other / 2, other % 2))
            at = partner(other)
        }
        return places.copyOf(size)
    }

    private companion object {
        /** More than two pieces end here. */
        const val CROWD = -2
    }
}

/**
 * Straight pieces of edges on the raster, visible ones or hidden ones. A growing list; not thread safe.
 */
internal class Pieces {
    private var places = DoubleArray(64)
    private var ends = IntArray(32)
    private var kinds = ByteArray(16)

    /** Number of pieces. */
    var count: Int = 0
        private set

    /** Column of an [end] (0 or 1) of piece [i], pixels. */
    fun x(i: Int, end: Int): Double = places[4 * i + 2 * end]

    /** Row of an [end] of piece [i], pixels. */
    fun y(i: Int, end: Int): Double = places[4 * i + 2 * end + 1]

    /** The point of the model at an [end] of piece [i]; -1 if the piece ends between two points. */
    fun point(i: Int, end: Int): Int = ends[2 * i + end]

    /** What piece [i] is a part of. */
    fun kind(i: Int): LineKind = LineKind.entries[kinds[i].toInt()]

    fun add(x0: Double, y0: Double, point0: Int, x1: Double, y1: Double, point1: Int, kind: LineKind) {
        if (count == kinds.size) {
            places = places.copyOf(2 * places.size)
            ends = ends.copyOf(2 * ends.size)
            kinds = kinds.copyOf(2 * kinds.size)
        }
        places[4 * count] = x0
        places[4 * count + 1] = y0
        places[4 * count + 2] = x1
        places[4 * count + 3] = y1
        ends[2 * count] = point0
        ends[2 * count + 1] = point1
        kinds[count] = kind.ordinal.toByte()
        count++
    }

    /** Adds piece [i] of [other]. */
    fun add(other: Pieces, i: Int): Unit = add(
        other.x(i, 0), other.y(i, 0), other.point(i, 0), other.x(i, 1), other.y(i, 1), other.point(i, 1),
        other.kind(i),
    )

    fun addAll(other: Pieces) {
        for (i in 0 until other.count) add(other, i)
    }

    /** Returns the pieces of one [kind]. */
    fun of(kind: LineKind): Pieces {
        val own = Pieces()
        for (i in 0 until count) if (kinds[i].toInt() == kind.ordinal) own.add(this, i)
        return own
    }
}

/**
 * Removes crumbs from [pieces]: short parts of silhouettes that are visible between hidden parts, far from other lines.
 * A silhouette of triangles is a zigzag around that of the smooth surface, so where a rough surface is seen almost
 * along its tangent, crumbs of the zigzag appear.
 *
 * Pieces that are at most [near] pixels apart belong together. What belongs together is removed if it has only
 * outlines, is partly hidden, and is shorter than [least] pixels. Used once; not thread safe. Cost: linear in the
 * number of pieces and in their length in pixels.
 *
 * @param pointCount number of points of the model
 * @param checkpoint passed for each piece
 */
internal class ShortPieces(
    private val pieces: Pieces,
    pointCount: Int,
    private val least: Double,
    private val near: Double,
    private val checkpoint: Checkpoint,
) {
    private val parent = IntArray(pieces.count) { it }

    /** By point: how many pieces end there. */
    private val endsAt = IntArray(pointCount)

    /** Returns the pieces that are no crumbs. */
    fun removed(): Pieces {
        if ((0 until pieces.count).all(::isFeature)) return pieces
        for (i in 0 until 2 * pieces.count) pieces.point(i / 2, i % 2).let { if (it >= 0) endsAt[it]++ }
        connect()
        val length = DoubleArray(pieces.count)
        val isKept = BooleanArray(pieces.count)
        val isCut = BooleanArray(pieces.count)
        for (i in 0 until pieces.count) {
            val root = root(i)
            length[root] += length(i)
            if (isFeature(i)) isKept[root] = true
            if (isLoose(pieces.point(i, 0)) || isLoose(pieces.point(i, 1))) isCut[root] = true
        }
        val rest = Pieces()
        for (i in 0 until pieces.count) {
            val root = root(i)
            if (isKept[root] || !isCut[root] || length[root] >= least) rest.add(pieces, i)
        }
        return rest
    }

    private fun isFeature(i: Int) = pieces.kind(i) != LineKind.OUTLINE

    /** Whether only one piece ends at [point], or the piece ends between two points. */
    private fun isLoose(point: Int) = point < 0 || endsAt[point] == 1

    /** Connects pieces that reach the same cell of a grid. A place reaches all cells that are within half a cell. */
    private fun connect() {
        val cells = DistinctTriples()
        val pieceIn = ArrayList<Int>()
        for (i in 0 until pieces.count) {
            checkpoint.pass()
            val steps = ceil(length(i) / near).toInt()
            for (step in 0..steps) {
                val t = if (steps == 0) 0.0 else step.toDouble() / steps
                val x = pieces.x(i, 0) + t * (pieces.x(i, 1) - pieces.x(i, 0))
                val y = pieces.y(i, 0) + t * (pieces.y(i, 1) - pieces.y(i, 0))
                for (corner in 0 until 4) {
                    val column = floor(x / near + (corner % 2) - 0.5).toInt()
                    val row = floor(y / near + (corner / 2) - 0.5).toInt()
                    val cell = cells.add(column, row, 0)
                    if (cell == pieceIn.size) pieceIn += i else parent[root(i)] = root(pieceIn[cell])
                }
            }
        }
    }

    private fun length(i: Int): Double {
        val x = pieces.x(i, 1) - pieces.x(i, 0)
        val y = pieces.y(i, 1) - pieces.y(i, 0)
        return StrictMath.sqrt(x * x + y * y)
    }

    private fun root(piece: Int): Int {
        var at = piece
        while (parent[at] != at) {
            parent[at] = parent[parent[at]]
            at = parent[at]
        }
        return at
    }
}
