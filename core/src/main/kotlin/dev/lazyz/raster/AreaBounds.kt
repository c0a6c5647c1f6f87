package dev.lazyz.raster

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.spi.LinearForm

/**
 * Bounds of a primitive's depth within an area (a rectangle of samples), without evaluating each sample.
 *
 * Used by renderers that decide visibility for whole areas. A linear form has its minimum and maximum at corners of the
 * area, and the signs of its steps determine which corners. So a bound costs one evaluation. A primitive without a form
 * uses its own bounds. Used by one thread.
 *
 * The following shows why the corners bound the covered samples, even though the form can wrap around at samples that
 * are not covered. Suppose that the form, as an exact integer, changes by less than 2^63 between any two samples of the
 * area ([isGentle]).
 *
 * - Two covered samples: both values are in 0 until 2^63, so their difference is below 2^63 in absolute value. So is
 *   the exact change. Both are equal modulo 2^64, hence equal. So all covered samples lie in one exact plane.
 * - A corner of an area that has a covered sample: the exact value of that plane at the corner is in -2^63 until 2^64.
 *   If it is in 0 until 2^63, the wrapped value equals the exact one; otherwise the wrapped value is negative. So a
 *   wrapped value that is not negative is exact, and a negative one gives no bound.
 */
internal class AreaBounds(test: DepthTest, private val counters: Counters.Builder) {
    private val order = VisibilityOrder(test)

    /** 1 if the smallest depth wins, -1 if the greatest wins: the lead of value 0 over value 1. */
    private val direction = order.lead(0, 1)

    /**
     * Returns a lower bound of the keys of all fragments of [primitive] in [area]. Cost: at most one depth evaluation.
     */
    fun nearestKey(primitive: Primitive, index: Int, area: Region): Long {
        val bound = order.nearestKey(primitive, index)
        val form = primitive.depthForm ?: return bound
        val value = extreme(form, area, direction)
        return if (value < 0) bound else maxOf(bound, order.key(value, index))
    }

    /**
     * Returns an upper bound of the keys of all fragments of [primitive] in [area]. Cost: at most one depth evaluation.
     */
    fun farthestKey(primitive: Primitive, index: Int, area: Region): Long {
        val bound = order.farthestKey(primitive, index)
        val form = primitive.depthForm ?: return bound
        val value = extreme(form, area, -direction)
        return if (value < 0) bound else minOf(bound, order.key(value, index))
    }

    /**
     * Returns true if the plane [front], of a primitive that covers all of [area], certainly leads the plane [behind]
     * by at least [leastLead] everywhere in the area, see [VisibilityOrder.leastLead]. Cost: at most two depth
     * evaluations.
     */
    fun leads(front: LinearForm, behind: LinearForm, area: Region, leastLead: Long): Boolean {
        if (!isGentle(front, area) || !isGentle(behind, area)) return false

        // The lead is a linear form too: evaluate it at the corner where it is smallest
        val x = if (order.lead(front.dx, behind.dx) >= 0) area.columnStart else area.columnEnd - 1
        val y = if (order.lead(front.dy, behind.dy) >= 0) area.rowStart else area.rowEnd - 1
        counters.depthEvaluations += 2
        val value = behind.at(x, y)
        return value >= 0 && order.lead(front.at(x, y), value) >= leastLead
    }

    /**
     * Returns the minimum of the form in [area] if [sign] is 1, the maximum if it is -1; a negative number if it is
     * unknown.
     */
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
        /** 2^62: half of the limit, so that the rounding of four operations does not matter. */
        const val GENTLE = 4611686018427387904.0
    }
}
