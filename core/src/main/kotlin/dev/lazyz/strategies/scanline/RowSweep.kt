package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.endIfInterrupted

/**
 * Moves along a row from edge to edge, and determines the visible opaque primitive and its depth at every sample.
 *
 * Between two edges, the tournament of spans with linear depth yields runs of one visible span, whose depth is stepped.
 * For each run, the primitives without linear depth are then compared, except those that their bounds prove to be
 * hidden.
 *
 * Source: Jack Bouknight, "A Procedure for Generation of Three-dimensional Half-toned Computer Graphics Presentations",
 * Communications of the ACM 13 (1970), for the sweep.
 */
internal class RowSweep(
    private val frame: Frame,
    private val edges: ActiveEdges,
    private val counters: Counters.Builder
) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val hasLayers = frame.hasTranslucency
    private val duel = Duel(frame, edges, counters)
    private val tournament = Tournament(edges, duel)
    private val curved = CurvedSpans(frame, edges, counters)

    /** Depths of the row, from the region's first column. */
    val depths: IntArray = IntArray(region.width)

    /** Visible primitives of the row, or [DepthTest.BACKGROUND]. */
    val indices: IntArray = IntArray(region.width)

    /** Bytes currently held. */
    val bytes: Long get() = 8L * region.width + tournament.bytes + curved.bytes

    /** Fills [depths] and [indices] with row [y]. The edges must already be at this row. */
    fun sweep(y: Int) {
        duel.moveTo(y)
        tournament.begin(y)
        var edge = 0
        var x = region.columnStart
        while (x < region.columnEnd) {
            // Add spans that start at this column, remove spans that end here
            while (edge < edges.count && edges.column(edge) == x) pass(edge++)

            // The candidates stay the same until the next edge
            val spanEnd = if (edge < edges.count) edges.column(edge) else region.columnEnd
            while (x < spanEnd) {
                endIfInterrupted()
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
        val primitive = frame.primitives[edges.primitive(span)]
        if (hasLayers && primitive.isTranslucent) return
        val isLinear = primitive.depthForm != null
        if (edges.isStart(edge)) {
            if (isLinear) tournament.join(span) else curved.join(span)
        } else {
            if (isLinear) tournament.leave(span) else curved.leave(span)
        }
    }

    /** Writes [span] at the columns [start] until [end], except where a primitive without linear depth is before it. */
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

        // Depth is monotone along the run, so its farthest key is at one of the ends
        if (!curved.isEmpty) {
            val farthest = maxOf(test.key(depths[from], index), test.key(depths[to - 1], index))
            curved.show(depths, indices, start, end, y, farthest)
        }
    }
}
