package dev.lazyz.raster

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Region

/**
 * How near and how far a primitive can be within an area, a rectangle of samples, without looking at each sample.
 *
 * Shared by the renderers that decide areas at a time. A linear form is least and greatest at corners of the area,
 * which the signs of its steps name; so a bound takes one evaluation. Where there is no form the primitive's own
 * bounds serve. Belongs to one thread.
 *
 * Why corners bound what is covered, though a form wraps around where it is not. Let the form change by less than 2^63
 * from any sample of the area to any other ([isGentle]), counted in true integers.
 *
 * - Two covered samples: both values are in 0 until 2^63, so their difference is below 2^63 in absolute value; so is
 *   the
 *   true change; the two are equal modulo 2^64, hence equal. Covered samples lie in one true plane.
 * - A corner, in an area with a covered sample: the true value of that plane there is in -2^63 until 2^64. If it is in
 *   0 until 2^63 the wrapped value is the true one, and otherwise the wrapped value is negative. So a value that is not
 *   negative is true, and one that is proves nothing.
 */
internal class AreaBounds(test: DepthTest, private val counters: Counters) {
    private val order = VisibilityOrder(test)

    /** 1 where the least depth wins, -1 where the greatest does: the sign of a lead of 1. */
    private val direction = order.lead(0, 1)

    /** Returns a key that no fragment of [primitive] in [area] is before. Cost: one depth evaluation at most. */
    fun nearestKey(primitive: Primitive, index: Int, area: Region): Long {
        val bound = order.nearestKey(primitive, index)
        val form = primitive.depthForm ?: return bound
        val value = extreme(form, area, direction)
        return if (value < 0) bound else maxOf(bound, order.key(value, index))
    }

    /** Returns a key that no fragment of [primitive] in [area] is behind. Cost: one depth evaluation at most. */
    fun farthestKey(primitive: Primitive, index: Int, area: Region): Long {
        val bound = order.farthestKey(primitive, index)
        val form = primitive.depthForm ?: return bound
        val value = extreme(form, area, -direction)
        return if (value < 0) bound else minOf(bound, order.key(value, index))
    }

    /**
     * Whether it is proved that the plane [front] of a primitive that covers all of [area] leads the plane [behind]
     * everywhere in it by [leastLead], see [VisibilityOrder.leastLead]. Cost: two depth evaluations at most.
     */
    fun leads(front: LinearForm, behind: LinearForm, area: Region, leastLead: Long): Boolean {
        if (!isGentle(front, area) || !isGentle(behind, area)) return false

        // The lead is a linear form as well: go where it is least
        val x = if (order.lead(front.dx, behind.dx) >= 0) area.columnStart else area.columnEnd - 1
        val y = if (order.lead(front.dy, behind.dy) >= 0) area.rowStart else area.rowEnd - 1
        counters.depthEvaluations += 2
        val value = behind.at(x, y)
        return value >= 0 && order.lead(front.at(x, y), value) >= leastLead
    }

    /** Returns the form's least value in [area] for the [sign] 1, its greatest for -1; negative if it is not known. */
    private fun extreme(form: LinearForm, area: Region, sign: Long): Long {
        if (!isGentle(form, area)) return -1
        counters.depthEvaluations++
        val x = if ((form.dx >= 0) == (sign > 0)) area.columnStart else area.columnEnd - 1
        val y = if ((form.dy >= 0) == (sign > 0)) area.rowStart else area.rowEnd - 1
        return form.at(x, y)
    }

    /** Whether the form changes so little over [area] that it cannot wrap around between covered samples. */
    private fun isGentle(form: LinearForm, area: Region): Boolean {
        val alongRow = StrictMath.abs(form.dx.toDouble()) * (area.width - 1)
        val alongColumn = StrictMath.abs(form.dy.toDouble()) * (area.height - 1)
        return alongRow + alongColumn < GENTLE
    }

    private companion object {
        /** 2^62: half of what is needed, so that the rounding of four operations does not matter. */
        const val GENTLE = 4611686018427387904.0
    }
}
