package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.LinearForm
import dev.lazyz.raster.VisibilityOrder

/**
 * Decides which of two spans is visible from a column on, and until which column this result holds.
 *
 * Bounds of depth are compared first, which takes no depth evaluation. Otherwise the two forms are evaluated at both
 * ends of the columns that the spans share. If one span leads at both ends, it is visible at all columns between, see
 * [VisibilityOrder]. If the spans cross, one exact division gives the column until which the lead lasts. The spans are
 * compared sample by sample only where they are within one unit of depth, or where rounding hides which is nearer.
 *
 * The background takes part as a span of constant depth, whose evaluation is not counted.
 */
internal class Duel(private val frame: Frame, private val edges: ActiveEdges, private val counters: Counters.Builder) {
    private val order = VisibilityOrder(frame.raster.depthTest)
    private val background = LinearForm.constant(frame.raster.backgroundDepth)
    private val backgroundKey = frame.raster.depthTest.key(frame.raster.backgroundDepth, -1)
    private var row = 0

    /** The visible span, set by [judge]. */
    var winner: Int = 0
        private set

    /** The column until which [winner] is visible, set by [judge]. */
    var until: Int = 0
        private set

    fun moveTo(y: Int) {
        row = y
    }

    /**
     * Decides between the spans [a] and [b], which cover column [x]. If they are compared sample by sample, the
     * comparison ends at [limit].
     */
    fun judge(a: Int, b: Int, x: Int, limit: Int) {
        val end = minOf(edges.end(a), edges.end(b))
        if (farthestKey(a) < nearestKey(b)) {
            decide(a, end)
        } else if (farthestKey(b) < nearestKey(a)) {
            decide(b, end)
        } else {
            judgeByForms(a, b, x, end, limit)
        }
    }

    private fun decide(span: Int, column: Int) {
        winner = span
        until = column
    }

    private fun judgeByForms(a: Int, b: Int, x: Int, end: Int, limit: Int) {
        // Determine which span is visible at x, and its lead
        val valueA = value(a, x)
        val valueB = value(b, x)
        val isA = order.key(valueA, edges.primitive(a)) < order.key(valueB, edges.primitive(b))
        val front = if (isA) a else b
        val behind = if (isA) b else a
        val needed = order.leastLead(edges.primitive(front), edges.primitive(behind))
        val lead = if (isA) order.lead(valueA, valueB) else order.lead(valueB, valueA)

        // The front span is visible as long as it keeps the lead that it needs
        if (lead < needed) {
            decide(front, endBySamples(front, behind, x, minOf(end, limit), needed))
        } else if (end == x + 1 || order.lead(value(front, end - 1), value(behind, end - 1)) >= needed) {
            decide(front, end)
        } else {
            decide(front, x + 1 + columnsAhead(front, behind, lead - needed))
        }
    }

    /** Returns for how many columns [front] keeps the lead that it needs, if it now has [spare] more than that. */
    private fun columnsAhead(front: Int, behind: Int, spare: Long): Int {
        // The lead is known to become too small, so the step is negative, unless it does not fit into 64 bits
        val step = order.lead(form(front).dx, form(behind).dx)
        return if (step < 0) (spare / -step).toInt() else 0
    }

    /**
     * Compares sample by sample. Returns the first column after [x] where [front] is hidden or has at least the
     * [needed] lead.
     */
    private fun endBySamples(front: Int, behind: Int, x: Int, end: Int, needed: Long): Int {
        var column = x + 1
        while (column < end) {
            val valueFront = value(front, column)
            val valueBehind = value(behind, column)
            val isHidden =
                order.key(valueFront, edges.primitive(front)) > order.key(valueBehind, edges.primitive(behind))
            if (isHidden || order.lead(valueFront, valueBehind) >= needed) return column
            column++
        }
        return column
    }

    /** Evaluates the depth of [span] at a column that it covers. */
    private fun value(span: Int, x: Int): Long {
        if (span != ActiveEdges.BACKGROUND_SPAN) counters.depthEvaluations++
        return form(span).at(x, row)
    }

    /** The depth of [span] as a linear form. */
    fun form(span: Int): LinearForm =
        if (span == ActiveEdges.BACKGROUND_SPAN) background else frame.primitives[edges.primitive(span)].depthForm!!

    private fun nearestKey(span: Int): Long {
        if (span == ActiveEdges.BACKGROUND_SPAN) return backgroundKey
        val index = edges.primitive(span)
        return order.nearestKey(frame.primitives[index], index)
    }

    private fun farthestKey(span: Int): Long {
        if (span == ActiveEdges.BACKGROUND_SPAN) return backgroundKey
        val index = edges.primitive(span)
        return order.farthestKey(frame.primitives[index], index)
    }
}
