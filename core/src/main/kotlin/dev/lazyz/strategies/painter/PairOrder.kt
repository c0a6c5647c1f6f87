package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.bytes
import dev.lazyz.raster.Edge
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.forEachRow
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Spans

/**
 * Newell's tests: try to prove which of two primitives is visible at all samples that they share. The order is proved
 * if one of these holds:
 *
 * - Their extents of depth are disjoint.
 * - The corners of the farther primitive are all behind the plane of the nearer.
 * - The corners of the nearer primitive are all before the plane of the farther.
 * - One plane is before the other at the corners of the intersection of their boxes on the screen.
 *
 * Corners are those of the convex hull of the covered samples. Before and behind refer to the exact order of
 * [VisibilityOrder], including ties. The lead is a linear form, so what holds at the corners of either primitive, or of
 * the box, holds at all samples within, and therefore at those that both cover.
 *
 * Source: Newell, Newell, Sancha, "A Solution to the Hidden Surface Problem" (1972), except the last test, which is new
 * here: if two long bars cross on the screen, each one's plane intersects the other far from where the bars overlap.
 */
internal class PairOrder(private val frame: Frame, private val counters: Counters.Builder) {
    private val order = VisibilityOrder(frame.raster.depthTest)
    private val facets = arrayOfNulls<Facet>(frame.primitives.size)
    private val backgroundKey = frame.raster.depthTest.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)

    /** The factor for leads: -1 where the greatest depth wins, otherwise 1. */
    private val direction = order.lead(0, 1).toDouble()

    /** Bytes currently held. */
    var bytes: Long = facets.bytes
        private set

    /** Returns a lower bound of the keys of the primitive [index], or of the background. */
    fun nearestKey(index: Int): Long =
        if (index == DepthTest.BACKGROUND) backgroundKey else order.nearestKey(frame.primitives[index], index)

    /** Returns an upper bound of the keys of the primitive [index], or of the background. */
    fun farthestKey(index: Int): Long =
        if (index == DepthTest.BACKGROUND) backgroundKey else order.farthestKey(frame.primitives[index], index)

    /** Whether it is proved that [front] is visible, and not [behind], wherever both cover a sample. */
    fun isBefore(front: Int, behind: Int): Boolean {
        // Extents of depth decide most pairs, in one direction or the other
        if (farthestKey(front) < nearestKey(behind)) return true
        if (nearestKey(front) > farthestKey(behind)) return false
        if (front == DepthTest.BACKGROUND || behind == DepthTest.BACKGROUND) return false

        // Otherwise compare the planes
        val a = facet(front)
        val b = facet(behind)
        if (!(a.isFlat && b.isFlat)) return false
        val needed = order.leastLead(front, behind)
        if (a.isSamePlane(b)) return needed == 0L
        return leadsAtCorners(a, b, b.outline, needed) || leadsAtCorners(a, b, a.outline, needed) ||
            leadsInSharedBox(a, b, needed)
    }

    /** Whether the outlines of two primitives prove that they share no sample. */
    fun isApart(a: Int, b: Int): Boolean = facet(a).outline.isApart(facet(b).outline)

    private fun leadsAtCorners(front: Facet, behind: Facet, corners: Outline, needed: Long): Boolean {
        for (i in 0 until corners.count) if (!leads(front, behind, corners.xs[i], corners.ys[i], needed)) return false
        return true
    }

    private fun leadsInSharedBox(front: Facet, behind: Facet, needed: Long): Boolean {
        val left = maxOf(front.outline.left, behind.outline.left)
        val right = minOf(front.outline.right, behind.outline.right)
        val top = maxOf(front.outline.top, behind.outline.top)
        val bottom = minOf(front.outline.bottom, behind.outline.bottom)
        if (left > right || top > bottom) return true
        return leads(front, behind, left, top, needed) && leads(front, behind, right, top, needed) &&
            leads(front, behind, left, bottom, needed) && leads(front, behind, right, bottom, needed)
    }

    private fun leads(front: Facet, behind: Facet, x: Int, y: Int, needed: Long): Boolean {
        counters.depthEvaluations += 2
        return behind.leastHeight(front, x, y, direction) >= needed
    }

    private fun facet(index: Int): Facet {
        val known = facets[index]
        if (known != null) return known
        val facet = Facet.of(frame.primitives[index], frame.region)
        facets[index] = facet
        counters.depthEvaluations += facet.valueCount
        bytes += facet.bytes
        return facet
    }
}

/**
 * What Newell's tests need to know about a primitive: the corners of its outline, and its depth plane.
 *
 * A linear form is exact at the primitive's own samples; elsewhere its value may not fit into 64 bits. The plane is
 * therefore extrapolated from the first corner, in double precision with a bound on the error.
 */
internal class Facet private constructor(
    val outline: Outline,
    private val form: LinearForm?,
    private val values: LongArray,
) {
    /** Whether depth is a single plane over all samples of the primitive. */
    val isFlat: Boolean = form != null && outline.count > 0 && isOnePlane()

    /** Number of corners at which depth was evaluated. */
    val valueCount: Int get() = values.size

    /** Bytes held. */
    val bytes: Long get() = HeapLayout.FACET + 8L * outline.count + values.bytes

    /** Whether both lie in exactly the same plane. */
    fun isSamePlane(other: Facet): Boolean = form == other.form

    /**
     * Returns a lower bound of [sign] (1 or -1) times the height of this plane above that of [other] at column [x] and
     * row [y], in units of linear forms. The bound is lower than the exact value only by rounding, about 2^-49 of the
     * numbers that were added.
     */
    fun leastHeight(other: Facet, x: Int, y: Int, sign: Double): Double {
        val across = form!!.dx.toDouble() * (x - outline.xs[0])
        val down = form.dy.toDouble() * (y - outline.ys[0])
        val otherAcross = other.form!!.dx.toDouble() * (x - other.outline.xs[0])
        val otherDown = other.form.dy.toDouble() * (y - other.outline.ys[0])
        val over = (values[0] - other.values[0]).toDouble()

        // A number takes part in at most two roundings before the sums and four in them, each at most 2^-53 of its
        // contribution
        val height = over + ((across + down) - (otherAcross + otherDown))
        val sum = StrictMath.abs(over) + StrictMath.abs(across) + StrictMath.abs(down) +
            StrictMath.abs(otherAcross) + StrictMath.abs(otherDown)
        return sign * height - ROUNDING * sum
    }

    /**
     * Whether the plane through the first corner equals the form at all corners. If so, the form is in range there and
     * at all samples in between, and never wraps: a form that wraps is off by a multiple of 2^64. Only forms of custom
     * primitives can wrap.
     */
    private fun isOnePlane(): Boolean {
        for (i in values.indices) {
            val across = form!!.dx.toDouble() * (outline.xs[i] - outline.xs[0])
            val down = form.dy.toDouble() * (outline.ys[i] - outline.ys[0])
            val error = StrictMath.abs((across + down) - (values[i] - values[0]).toDouble())
            if (error > HALF_WRAP) return false
        }
        return true
    }

    companion object {
        private const val ROUNDING = 1.0 / (1L shl 49)

        /** 2^63: rounding errors are far smaller, and a wrapped value is off by twice as much. */
        private const val HALF_WRAP = 9223372036854775808.0

        /** Examines the samples of [primitive] in [region]. Cost: see [Outline.of]. */
        fun of(primitive: Primitive, region: Region): Facet {
            val outline = Outline.of(primitive, region)
            val form = primitive.depthForm
            val values = LongArray(if (form == null) 0 else outline.count) { form!!.at(outline.xs[it], outline.ys[it]) }
            return Facet(outline, form, values)
        }
    }
}

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
