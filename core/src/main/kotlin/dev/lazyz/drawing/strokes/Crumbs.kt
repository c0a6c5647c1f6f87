package dev.lazyz.drawing.strokes

import dev.lazyz.Checkpoint
import dev.lazyz.geometry.DistinctTriples
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Removes crumbs from [pieces]: short parts of silhouettes that are visible between hidden parts, far from other lines.
 * A silhouette of triangles is a zigzag around that of the smooth surface, so where a rough surface is seen almost
 * along its tangent, crumbs of the zigzag appear.
 *
 * Pieces that are at most [near] pixels apart belong together. What belongs together is removed if it has no boundary
 * and no crease, is partly hidden, and is shorter than [least] pixels. Used once; not thread safe. Cost: linear in the
 * number of pieces and in their length in pixels.
 *
 * @param pointCount number of points of the model
 * @param checkpoint passed for each piece
 */
internal class Crumbs(
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
        if ((0 until pieces.count).all { pieces.isFeature(it) }) return pieces
        for (i in 0 until 2 * pieces.count) pieces.point(i / 2, i % 2).let { if (it >= 0) endsAt[it]++ }
        connect()
        val length = DoubleArray(pieces.count)
        val isKept = BooleanArray(pieces.count)
        val isCut = BooleanArray(pieces.count)
        for (i in 0 until pieces.count) {
            val root = root(i)
            length[root] += length(i)
            if (pieces.isFeature(i)) isKept[root] = true
            if (isLoose(pieces.point(i, 0)) || isLoose(pieces.point(i, 1))) isCut[root] = true
        }
        val rest = Pieces()
        for (i in 0 until pieces.count) {
            val root = root(i)
            if (isKept[root] || !isCut[root] || length[root] >= least) rest.add(pieces, i)
        }
        return rest
    }

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
