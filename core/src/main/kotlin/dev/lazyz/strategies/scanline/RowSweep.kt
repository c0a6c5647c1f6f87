package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame

/**
 * Goes along a row from edge to edge, and finds the visible primitive and its depth at every sample.
 *
 * Between two edges the tournament of spans with linear depth gives runs of one visible span, whose depth is stepped.
 * Over each run the primitives without linear depth are compared, as far as their bounds do not hide them behind it.
 *
 * Source: Jack Bouknight, "A Procedure for Generation of Three-dimensional Half-toned Computer Graphics Presentations",
 * Communications of the ACM 13 (1970), for the sweep.
 */
internal class RowSweep(private val frame: Frame, private val edges: ActiveEdges, private val counters: Counters) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val duel = Duel(frame, edges, counters)
    private val tournament = Tournament(edges, duel)
    private val curved = CurvedSpans(frame, edges, counters)

    /** Depths of the row, from the region's first column. */
    val depths: IntArray = IntArray(region.width)

    /** Visible primitives of the row, or [DepthTest.BACKGROUND]. */
    val indices: IntArray = IntArray(region.width)

    /** Bytes held at present. */
    val bytes: Long get() = 8L * region.width + tournament.bytes + curved.bytes

    /** Fills [depths] and [indices] with row [y], to which the edges have moved. */
    fun sweep(y: Int) {
        duel.moveTo(y)
        tournament.begin(y)
        var edge = 0
        var x = region.columnStart
        while (x < region.columnEnd) {
            // Spans that begin at this column join, those that end leave
            while (edge < edges.count && edges.column(edge) == x) pass(edge++)

            // Up to the next edge the candidates stay the same
            val spanEnd = if (edge < edges.count) edges.column(edge) else region.columnEnd
            while (x < spanEnd) {
                tournament.goTo(x, spanEnd)
                val until = minOf(tournament.until, spanEnd)
                show(tournament.winner, x, until, y)
                x = until
            }
        }
        while (edge < edges.count) pass(edge++)
    }

    private fun pass(edge: Int) {
        val span = edges.span(edge)
        val isLinear = frame.primitives[edges.primitive(span)].depthForm != null
        if (edges.isStart(edge)) {
            if (isLinear) tournament.join(span) else curved.join(span)
        } else {
            if (isLinear) tournament.leave(span) else curved.leave(span)
        }
    }

    /** Shows [span] at the columns [start] until [end], but for what lies before it and has no linear depth. */
    private fun show(span: Int, start: Int, end: Int, y: Int) {
        val index = edges.primitive(span)
        val from = start - region.columnStart
        val to = end - region.columnStart
        val form = duel.form(span)
        if (index != DepthTest.BACKGROUND) {
            counters.depthEvaluations += to - from
            counters.depthPasses += to - from
        }

        // Step the depth along the run
        var z = form.at(start, y)
        for (i in from until to) {
            depths[i] = (z shr 32).toInt()
            z += form.dx
        }
        indices.fill(index, from, to)

        // Depth is monotone along the run, so its farthest key is at an end
        if (!curved.isEmpty) {
            val farthest = maxOf(test.key(depths[from], index), test.key(depths[to - 1], index))
            curved.show(depths, indices, start, end, y, farthest)
        }
    }
}
