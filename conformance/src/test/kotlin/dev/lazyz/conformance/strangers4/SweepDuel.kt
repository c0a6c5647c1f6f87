package dev.lazyz.conformance.strangers4

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.LinearForm

/**
 * Asks which primitive is visible at a column, and whether it stays so.
 *
 * Of two linear forms the one that is before the other at both ends of a run is so in between. As depth is the form's
 * value rounded down, its depth is not behind then; where the other would win a tie it has to lead by a whole unit.
 */
internal class SweepDuel(
    private val frame: Frame,
    private val counters: Counters.Builder,
    private val mistake: Mistake?
) {
    private val test = frame.raster.depthTest
    private val background = LinearForm.constant(frame.raster.backgroundDepth)

    /** Returns which of the [open] primitives is visible at a column, or the background. */
    fun winner(open: IntArray, count: Int, x: Int, y: Int): Int {
        var least = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
        if (mistake == Mistake.SWEEP_NO_BACKGROUND_DEPTH) least = Long.MAX_VALUE
        for (i in 0 until count) least = minOf(least, key(open[i], x, y))
        return test.indexOf(least)
    }

    /** Whether the winner at column [first] stays visible to the column [last]. */
    fun leadsAll(winner: Int, open: IntArray, count: Int, first: Int, last: Int, y: Int): Boolean {
        val hasBackground = mistake != Mistake.SWEEP_NO_BACKGROUND_DEPTH
        if (hasBackground && winner != DepthTest.BACKGROUND && !leads(winner, DepthTest.BACKGROUND, first, last, y)) {
            return false
        }
        for (i in 0 until count) if (open[i] != winner && !leads(winner, open[i], first, last, y)) return false
        return true
    }

    /** Returns the first column at which the [winner] may be hidden, or [start] if that is to be found by halving. */
    fun crossing(winner: Int, open: IntArray, count: Int, start: Int, end: Int, y: Int): Int {
        if (mistake != Mistake.SWEEP_CROSSING_DIVIDED || count != 2 || winner == DepthTest.BACKGROUND) return start
        val front = form(winner) ?: return start
        val behind = form(if (open[0] == winner) open[1] else open[0]) ?: return start
        val lead = lead(front.at(start, y), behind.at(start, y))
        val fall = lead(front.dx, behind.dx)
        if (fall >= 0) return start
        return (start + 1 + (lead.toDouble() / -fall.toDouble()).toInt()).coerceAtMost(end - 1)
    }

    private fun leads(front: Int, behind: Int, first: Int, last: Int, y: Int): Boolean {
        if (mistake == Mistake.SWEEP_CURVED_BY_ENDS || mistake == Mistake.SWEEP_LEAD_OF_DEPTHS) {
            val areKeysEnough = mistake == Mistake.SWEEP_LEAD_OF_DEPTHS && form(front) != null && form(behind) != null
            val isCurved = form(front) == null || form(behind) == null
            if (areKeysEnough || (mistake == Mistake.SWEEP_CURVED_BY_ENDS && isCurved)) {
                return key(front, first, y) < key(behind, first, y) && key(front, last, y) < key(behind, last, y)
            }
        }
        val frontForm = form(front) ?: return false
        val behindForm = form(behind)
        if (behindForm == null) {
            // Its bound is behind the farther end
            val bound = test.boundOf(frame.primitives[behind], behind)
            return maxOf(key(front, first, y), key(front, last, y)) < bound
        }
        counters.depthEvaluations += 4
        val winsTies = test.key(0, front) < test.key(0, behind) || mistake == Mistake.SWEEP_LEAD_IN_TIES
        val least = if (winsTies) 0L else UNIT
        return lead(frontForm.at(first, y), behindForm.at(first, y)) >= least &&
            lead(frontForm.at(last, y), behindForm.at(last, y)) >= least
    }

    private fun lead(front: Long, behind: Long): Long = if (test.isGreatestFirst) front - behind else behind - front

    private fun form(index: Int): LinearForm? =
        if (index == DepthTest.BACKGROUND) background else frame.primitives[index].depthForm

    private fun key(index: Int, x: Int, y: Int): Long {
        if (index == DepthTest.BACKGROUND) return test.key(frame.raster.backgroundDepth, index)
        counters.depthEvaluations++
        val form = form(index) ?: return test.key(frame.primitives[index].depth(x, y), index)
        return test.key((form.at(x, y) shr 32).toInt(), index)
    }

    private companion object {
        /** One unit of depth in a form's value. */
        const val UNIT = 1L shl 32
    }
}
