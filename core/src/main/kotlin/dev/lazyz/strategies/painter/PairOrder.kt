package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.bytes
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.spi.LinearForm

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
