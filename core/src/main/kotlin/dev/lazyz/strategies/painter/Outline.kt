package dev.lazyz.strategies.painter

import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.raster.Edge
import dev.lazyz.raster.forEachRow
import dev.lazyz.spi.Spans

/**
 * The corners of the convex hull of the samples that a primitive covers in a region, in order around the hull.
 *
 * Newell's tests use a polygon's vertices. Primitives here need not have vertices, and the distance between a vertex
 * and the nearest sample can be up to a pixel. The tests are actually about the samples, so the hull of the samples
 * gives exact results.
 *
 * Source: Alex Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing Letters
 * 9 (1979): here with a left and a right chain, by rows instead of columns.
 *
 * @property xs columns of the corners
 * @property ys rows of the corners
 */
internal class Outline private constructor(val xs: IntArray, val ys: IntArray) {
    /** Number of corners; 0 if nothing is covered. */
    val count: Int get() = xs.size

    /** The box around the corners: first and last column and row; empty if nothing is covered. */
    val left: Int = xs.minOrNull() ?: Int.MAX_VALUE
    val right: Int = xs.maxOrNull() ?: Int.MIN_VALUE
    val top: Int = ys.minOrNull() ?: Int.MAX_VALUE
    val bottom: Int = ys.maxOrNull() ?: Int.MIN_VALUE

    /** Whether a straight line separates the two outlines, so that they have no sample in common. */
    fun isApart(other: Outline): Boolean = isBeyondEdge(other) || other.isBeyondEdge(this)

    /** Whether all corners of [other] are strictly outside one of the edges. */
    private fun isBeyondEdge(other: Outline): Boolean {
        var previous = count - 1
        for (current in 0 until count) {
            var isBeyond = count > 1
            var i = 0
            while (isBeyond && i < other.count) {
                isBeyond = turn(xs[previous], ys[previous], xs[current], ys[current], other.xs[i], other.ys[i]) < 0
                i++
            }
            if (isBeyond) return true
            previous = current
        }
        return false
    }

    /** A chain of corners from top to bottom that turns in one direction only. */
    private class Chain(private val sign: Int) {
        var xs = IntArray(INITIAL)
        var ys = IntArray(INITIAL)
        var count = 0

        fun add(x: Int, y: Int) {
            while (count >= 2 && sign * turn(xs[count - 2], ys[count - 2], xs[count - 1], ys[count - 1], x, y) >= 0) {
                count--
            }
            if (count == xs.size) {
                xs = xs.copyOf(2 * count)
                ys = ys.copyOf(2 * count)
            }
            xs[count] = x
            ys[count] = y
            count++
        }
    }

    companion object {
        private const val INITIAL = 8

        /** Walks the rows of [primitive] in [region]. Cost: linear in rows and spans. */
        fun of(primitive: Primitive, region: Region): Outline {
            val spans = region.spans()
            val left = Chain(1)
            val right = Chain(-1)
            primitive.forEachRow(region, spans) { y ->
                if (spans.count > 0) {
                    left.add(spans.start(0), y)
                    right.add(spans.end(spans.count - 1) - 1, y)
                }
            }

            // Go down the right chain and up the left, without the left corners that coincide with right ones
            val isTopShared = left.count > 0 && left.xs[0] == right.xs[0]
            val isBottomShared = left.count > 1 && left.xs[left.count - 1] == right.xs[right.count - 1]
            val first = if (isTopShared) 1 else 0
            val last = left.count - if (isBottomShared) 1 else 0
            val xs = IntArray(right.count + last - first)
            val ys = IntArray(xs.size)
            right.xs.copyInto(xs, 0, 0, right.count)
            right.ys.copyInto(ys, 0, 0, right.count)
            for (i in first until last) {
                val to = xs.size - 1 - (i - first)
                xs[to] = left.xs[i]
                ys[to] = left.ys[i]
            }
            return Outline(xs, ys)
        }

        /** Positive if the path from a via b to c turns right on the screen, 0 if it is straight. */
        private fun turn(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int): Long =
            Edge.function(ax, ay, bx, by, cx, cy)
    }
}
