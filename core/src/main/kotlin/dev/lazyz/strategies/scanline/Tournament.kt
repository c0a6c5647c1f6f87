package dev.lazyz.strategies.scanline

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
