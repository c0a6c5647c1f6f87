package dev.lazyz.strategies.scanline

/**
 * Keeps the visible one of the spans at the current column, while the column goes from left to right.
 *
 * A binary tree: its leaves are the spans by number, an inner node remembers the visible one of its two subtrees and
 * the column until which that is certain. Going to a column replays only the nodes that are not certain there: those
 * above spans that joined or left, and those where two surfaces cross. So a row of k spans costs O(k log k) duels, not
 * one for each pair of spans that meet.
 *
 * Source: Julien Basch, Leonidas Guibas, John Hershberger, "Data structures for mobile data" (1997): the kinetic
 * tournament. There the events wait in a queue; here the least column of a subtree is kept at its root.
 */
internal class Tournament(private val edges: ActiveEdges, private val duel: Duel) {
    /** Number of leaves, a power of two; node 1 is the root, nodes 2n and 2n+1 are below node n. */
    private var leaves = 0

    /** The visible span of each subtree, or [NONE]; and the column until which that is certain, 0 if it is not. */
    private var winners = IntArray(0)
    private var certain = IntArray(0)

    /** The last duel of each node: the spans from both sides, who won, on which row, and until which column. */
    private var lefts = IntArray(0)
    private var rights = IntArray(0)
    private var duelWinners = IntArray(0)
    private var duelRows = IntArray(0)
    private var duelEnds = IntArray(0)
    private var row = 0

    /** Bytes held at present. */
    val bytes: Long get() = Int.SIZE_BYTES * 7L * winners.size

    /** The visible span, after [goTo]. */
    val winner: Int get() = winners[ROOT]

    /** The column until which it is visible, unless a span joins or leaves before, after [goTo]. */
    val until: Int get() = certain[ROOT]

    /** Begins row [y]. The spans of the last row have left, all but the background. */
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

    /** Lets [span] take part from the current column on. */
    fun join(span: Int) {
        winners[leaves + span] = span
        forget(span)
    }

    /** Lets [span] take part no longer. */
    fun leave(span: Int) {
        winners[leaves + span] = NONE
        forget(span)
    }

    private fun forget(span: Int) {
        // What is above an uncertain node is uncertain already
        var node = (leaves + span) / 2
        while (node >= ROOT && certain[node] != 0) {
            certain[node] = 0
            node /= 2
        }
    }

    /** Decides who is visible at column [x]; where surfaces nearly touch, not beyond [limit]. */
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

        // The same two may have met here before, on this row
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
