package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder

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

/**
 * The spans at the current column whose depth is not a linear form: those of spheres and of custom primitives.
 *
 * Only bounds of their depths are known, so the spans are sorted by the bound of their nearest key. The search ends at
 * the first span that is behind everything visible so far, without evaluating it. The spans before it are compared
 * sample by sample, as in a depth buffer. Adding or removing a span moves a part of the list, which takes a few
 * nanoseconds for a hundred spans.
 */
internal class CurvedSpans(
    private val frame: Frame,
    private val edges: ActiveEdges,
    private val counters: Counters.Builder
) {
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val columnStart = frame.region.columnStart

    /** Lower bounds of the primitives' keys, ascending, and the primitives' indices. */
    private var nearest = LongArray(INITIAL)
    private var indices = IntArray(INITIAL)
    private var count = 0

    /** Whether there are no such spans at the current column. */
    val isEmpty: Boolean get() = count == 0

    /** Bytes currently held. */
    val bytes: Long get() = nearest.bytes + indices.bytes

    /** Adds [span] at the current column. */
    fun join(span: Int) {
        if (count == nearest.size) {
            nearest = nearest.copyOf(2 * count)
            indices = indices.copyOf(2 * count)
        }
        val index = edges.primitive(span)
        val key = order.nearestKey(frame.primitives[index], index)
        val at = -nearest.binarySearch(key, 0, count) - 1
        nearest.copyInto(nearest, at + 1, at, count)
        indices.copyInto(indices, at + 1, at, count)
        nearest[at] = key
        indices[at] = index
        count++
    }

    /** Removes [span] at the current column. */
    fun leave(span: Int) {
        val index = edges.primitive(span)
        val at = nearest.binarySearch(order.nearestKey(frame.primitives[index], index), 0, count)
        nearest.copyInto(nearest, at, at + 1, count)
        indices.copyInto(indices, at, at + 1, count)
        count--
    }

    /**
     * Compares the spans at the columns [start] until [end] of row [y] with what is visible there so far, in [depths]
     * and [visible] (which start at the region's first column). None of the visible keys is behind [farthest].
     */
    fun show(depths: IntArray, visible: IntArray, start: Int, end: Int, y: Int, farthest: Long) {
        var farthestVisible = farthest
        for (candidate in 0 until count) {
            endIfInterrupted()

            // A span that is behind the farthest visible sample is hidden, and so are all spans after it
            if (nearest[candidate] > farthestVisible) return
            val index = indices[candidate]
            val primitive = frame.primitives[index]
            counters.depthEvaluations += end - start
            farthestVisible = Long.MIN_VALUE
            for (x in start until end) {
                val i = x - columnStart
                val depth = primitive.depth(x, y)
                val key = test.key(depth, index)
                val visibleKey = test.key(depths[i], visible[i])
                if (key < visibleKey) {
                    depths[i] = depth
                    visible[i] = index
                    counters.depthPasses++
                }
                farthestVisible = maxOf(farthestVisible, minOf(key, visibleKey))
            }
        }
    }

    private companion object {
        const val INITIAL = 16
    }
}
