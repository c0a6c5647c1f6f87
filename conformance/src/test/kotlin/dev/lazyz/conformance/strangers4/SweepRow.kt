package dev.lazyz.conformance.strangers4

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame

/** Decides a row: sorts where spans begin and end, and between two such events asks who leads at both ends. */
internal class SweepRow(private val frame: Frame, private val counters: Counters.Builder, mistake: Mistake?) {
    private val region = frame.region
    private val duel = SweepDuel(frame, counters, mistake)
    private var starts = LongArray(16)
    private var ends = LongArray(16)
    private var open = IntArray(16)
    private var openCount = 0
    private val test = frame.raster.depthTest
    private val isBackgroundKept = mistake == Mistake.SWEEP_BACKGROUND_KEPT

    val depths: IntArray = IntArray(region.width)
    val indices: IntArray = IntArray(region.width)

    /** Columns that were drawn in the last row, from the region's first. */
    private val drawn = BooleanArray(region.width) { true }

    val bytes: Long get() = 8L * (starts.size + ends.size) + 4L * open.size + 9L * region.width

    fun decide(y: Int, list: SweepList) {
        clear()
        if (starts.size < list.count) {
            starts = LongArray(2 * list.count)
            ends = LongArray(2 * list.count)
            open = IntArray(2 * list.count)
        }
        for (span in 0 until list.count) {
            starts[span] = list.start(span).toLong() shl 32 or span.toLong()
            ends[span] = list.end(span).toLong() shl 32 or span.toLong()
            counters.fragments += list.end(span) - list.start(span)
        }
        starts.sort(0, list.count)
        ends.sort(0, list.count)
        sweep(y, list)
    }

    private fun sweep(y: Int, list: SweepList) {
        openCount = 0
        var start = 0
        var end = 0
        var x = region.columnStart
        while (x < region.columnEnd) {
            while (end < list.count && column(ends[end]) == x) close(list.index(ends[end++].toInt()))
            while (start < list.count && column(starts[start]) == x) {
                open[openCount++] = list.index(starts[start++].toInt())
            }
            var until = region.columnEnd
            if (start < list.count) until = minOf(until, column(starts[start]))
            if (end < list.count) until = minOf(until, column(ends[end]))
            if (openCount > 0) resolve(x, until, y)
            x = until
        }
    }

    private fun clear() {
        for (i in 0 until region.width) {
            if (isBackgroundKept && !drawn[i]) continue
            depths[i] = frame.raster.backgroundDepth
            indices[i] = DepthTest.BACKGROUND
            drawn[i] = false
        }
    }

    private fun column(event: Long): Int = (event ushr 32).toInt()

    private fun close(index: Int) {
        var at = 0
        while (open[at] != index) at++
        openCount--
        for (i in at until openCount) open[i] = open[i + 1]
    }

    /** Shows what is visible of the open primitives in the columns [start] until [end]: halves them until one leads. */
    private fun resolve(start: Int, end: Int, y: Int) {
        val winner = duel.winner(open, openCount, start, y)
        if (end - start == 1 || duel.leadsAll(winner, open, openCount, start, end - 1, y)) {
            show(winner, start, end, y)
            return
        }
        val split = duel.crossing(winner, open, openCount, start, end, y)
        if (split > start) {
            show(winner, start, split, y)
            resolve(split, end, y)
            return
        }
        val middle = (start + end) ushr 1
        resolve(start, middle, y)
        resolve(middle, end, y)
    }

    private fun show(index: Int, start: Int, end: Int, y: Int) {
        if (index == DepthTest.BACKGROUND) return
        val primitive = frame.primitives[index]
        val form = primitive.depthForm
        var z = form?.at(start, y) ?: 0L
        counters.depthEvaluations += end - start
        counters.depthPasses += end - start
        for (x in start until end) {
            val i = x - region.columnStart
            depths[i] = if (form != null) (z shr 32).toInt() else primitive.depth(x, y)
            if (form != null) z += form.dx
            indices[i] = index
            drawn[i] = true
        }
    }
}
