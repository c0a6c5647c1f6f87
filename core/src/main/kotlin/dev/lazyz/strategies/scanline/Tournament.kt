package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.spi.LinearForm

/**
 * Maintains the visible one of the spans at the current column, as the column moves from left to right.
 *
 * A binary tree: the leaves are the spans by number. An inner node stores the visible one of its two subtrees and the
 * column until which this result holds. Moving to a column replays only the nodes whose results do not hold there:
 * those above spans that were added or removed, and those where two surfaces cross. A row of k spans thus takes O(k log
 * k) comparisons, not one for each pair of overlapping spans.
 *
 * Source: Julien Basch, Leonidas Guibas, John Hershberger, "Data structures for mobile data" (1997): the kinetic
 * tournament. In the paper, the events wait in a queue; here the least column of a subtree is stored at its root.
 */
internal class Tournament(private val edges: ActiveEdges, private val duel: Duel) {
    /** Number of leaves, a power of two; node 1 is the root, nodes 2n and 2n+1 are the children of node n. */
    private var leaves = 0

    /**
     * For each subtree, the visible span or [NONE], and the column until which this holds (0 if it must be recomputed).
     */
    private var winners = IntArray(0)
    private var certain = IntArray(0)

    /** For each node, the last comparison: the spans from both sides, the winner, the row, and the end column. */
    private var lefts = IntArray(0)
    private var rights = IntArray(0)
    private var duelWinners = IntArray(0)
    private var duelRows = IntArray(0)
    private var duelEnds = IntArray(0)
    private var row = 0

    /** Bytes currently held. */
    val bytes: Long get() = Int.SIZE_BYTES * 7L * winners.size

    /** The visible span, set by [goTo]. */
    val winner: Int get() = winners[ROOT]

    /** The column until which [winner] is visible unless a span is added or removed before, set by [goTo]. */
    val until: Int get() = certain[ROOT]

    /** Begins row [y]. All spans of the last row, except the background, must have been removed. */
    fun begin(y: Int) {
        row = y
        if (leaves < edges.spanLimit) {
            leaves = edges.spanLimit
            winners = IntArray(2 * leaves) { NONE }
            certain = IntArray(2 * leaves)
            certain.fill(Int.MAX_VALUE, leaves, 2 * leaves)
            lefts = IntArray(leaves)
            rights = IntArray(leaves)
            duelWinners = IntArray(leaves)
            duelEnds = IntArray(leaves)
            duelRows = IntArray(leaves) { NONE }
            join(ActiveEdges.BACKGROUND_SPAN)
        }
    }

    /** Adds [span] at the current column. */
    fun join(span: Int) {
        winners[leaves + span] = span
        forget(span)
    }

    /** Removes [span] at the current column. */
    fun leave(span: Int) {
        winners[leaves + span] = NONE
        forget(span)
    }

    private fun forget(span: Int) {
        // The ancestors of a node that must be recomputed are already marked
        var node = (leaves + span) / 2
        while (node >= ROOT && certain[node] != 0) {
            certain[node] = 0
            node /= 2
        }
    }

    /**
     * Determines the visible span at column [x]. Where surfaces nearly touch, the result does not extend beyond
     * [limit].
     */
    fun goTo(x: Int, limit: Int) {
        replay(ROOT, x, limit)
    }

    private fun replay(node: Int, x: Int, limit: Int) {
        if (certain[node] > x) return
        val left = 2 * node
        val right = left + 1
        replay(left, x, limit)
        replay(right, x, limit)
        val a = winners[left]
        val b = winners[right]
        val below = minOf(certain[left], certain[right])
        if (a == NONE || b == NONE) {
            winners[node] = if (a == NONE) b else a
            certain[node] = below
            return
        }

        // Reuse the result if the same two spans were compared here before, on this row
        val isOld = lefts[node] == a && rights[node] == b && duelRows[node] == row
        if (!isOld || duelEnds[node] <= x) {
            duel.judge(a, b, x, limit)
            lefts[node] = a
            rights[node] = b
            duelRows[node] = row
            duelWinners[node] = duel.winner
            duelEnds[node] = duel.until
        }
        winners[node] = duelWinners[node]
        certain[node] = minOf(below, duelEnds[node])
    }

    private companion object {
        const val ROOT = 1
        const val NONE = -1
    }
}

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
