package dev.lazyz.conformance.strangers5

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.LinearForm

/** The visible segments of a row so far, a linked list from left to right. */
internal class Segments(
    private val frame: Frame,
    private val counters: Counters.Builder,
    private val mistake: Mistake?
) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val isReverse = test.isReverse()
    private val backgroundForm = LinearForm.constant(frame.raster.backgroundDepth)
    private var starts = IntArray(FIRST)
    private var ends = IntArray(FIRST)
    private var owners = IntArray(FIRST)
    private var nexts = IntArray(FIRST)
    private var used = 0
    private var free = -1
    private var head = -1

    /** Ends of the runs that a comparison made, and their owners. */
    private var runEnds = IntArray(FIRST)
    private var runOwners = IntArray(FIRST)
    private var runs = 0

    /** The row. */
    var y: Int = 0

    /** Bytes held. */
    val bytes: Long get() = 16L * starts.size + 8L * runEnds.size

    /** Begins a row: all background. */
    fun begin() {
        if (mistake != Mistake.SPANS_POOL_GROWS) used = 0
        free = -1
        head = -1
        link(-1, region.columnStart, region.columnEnd, DepthTest.BACKGROUND)
    }

    /** Calls [action] for each segment. */
    inline fun forEach(action: (start: Int, end: Int, owner: Int) -> Unit) {
        var node = head
        while (node >= 0) {
            action(starts[node], ends[node], owners[node])
            node = nexts[node]
        }
    }

    /** Inserts the span [a] until [b] of the primitive [index]. */
    fun insert(index: Int, a: Int, b: Int) {
        var previous = -1
        var node = head
        while (node >= 0 && ends[node] <= a) {
            previous = node
            node = nexts[node]
        }
        while (node >= 0 && starts[node] < b) {
            val after = nexts[node]
            val start = starts[node]
            val end = ends[node]
            val owner = owners[node]
            val from = maxOf(a, start)
            val until = minOf(b, end)
            runs = 0
            compare(index, owner, from, until)
            if (runs == 1 && runOwners[0] == owner) {
                previous = node
                node = after
                continue
            }
            nexts[node] = free
            if (mistake != Mistake.SPANS_POOL_GROWS) free = node
            var tail = previous
            if (start < from) tail = link(tail, start, from, owner)
            var left = from
            for (run in 0 until runs) {
                if (runOwners[run] == index) counters.depthPasses += runEnds[run] - left
                tail = link(tail, left, runEnds[run], runOwners[run])
                left = runEnds[run]
            }
            if (until < end) tail = link(tail, until, end, owner)
            nexts[tail] = after
            previous = tail
            node = after
        }
    }

    private fun link(tail: Int, start: Int, end: Int, owner: Int): Int {
        if (tail >= 0 && owners[tail] == owner && ends[tail] == start) {
            ends[tail] = end
            return tail
        }
        val links = nexts
        val node = take()
        starts[node] = start
        ends[node] = end
        owners[node] = owner
        nexts[node] = -1
        if (tail < 0) head = node else (if (mistake == Mistake.SPANS_STALE_POOL) links else nexts)[tail] = node
        return node
    }

    private fun take(): Int {
        if (free >= 0) return free.also { free = nexts[it] }
        if (used == starts.size) {
            starts = starts.copyOf(2 * used)
            ends = ends.copyOf(2 * used)
            owners = owners.copyOf(2 * used)
            nexts = nexts.copyOf(2 * used)
        }
        return used++
    }

    private fun form(owner: Int): LinearForm? =
        if (owner == DepthTest.BACKGROUND) backgroundForm else frame.primitives[owner].depthForm

    private fun wins(newer: Int, older: Int): Boolean =
        (mistake == Mistake.SPANS_BACKGROUND_TIE && older == DepthTest.BACKGROUND) ||
            test.key(0, newer) < test.key(0, older)

    private fun compare(newer: Int, older: Int, from: Int, until: Int) {
        val a = form(newer)
        val b = form(older)
        if (a != null && b != null) {
            split(newer, older, a, b, from, until)
            return
        }
        if (mistake == Mistake.SPANS_CURVED_ENDS) {
            val first = nearer(newer, older, a, b, from)
            val middle = nearer(newer, older, a, b, (from + until) / 2)
            if (first == middle && first == nearer(newer, older, a, b, until - 1)) return run(until, first)
        }
        for (x in from until until) run(x + 1, nearer(newer, older, a, b, x))
    }

    /** Decides all samples where the forms' order at both ends does, or else each half. */
    private fun split(newer: Int, older: Int, a: LinearForm, b: LinearForm, from: Int, until: Int) {
        val left = lead(a, b, from)
        val right = if (until - from == 1) left else lead(a, b, until - 1)
        val least = if (wins(newer, older)) 0L else UNIT
        val most = if (wins(newer, older)) -UNIT else 0L
        if (mistake == Mistake.SPANS_CROSSING && left > 0L != right > 0L) {
            val way = left.toDouble() / (left.toDouble() - right.toDouble()) * (until - 1 - from)
            run((from + 1 + way.toInt()).coerceAtMost(until - 1), if (left > 0L) newer else older)
            return run(until, if (left > 0L) older else newer)
        }
        when {
            left >= least && right >= least -> run(until, newer)
            left <= most && right <= most -> run(until, older)
            until - from == 1 -> run(until, nearer(newer, older, a, b, from))
            else -> {
                val middle = (from + until) / 2
                split(newer, older, a, b, from, middle)
                split(newer, older, a, b, middle, until)
            }
        }
    }

    /** How far [a] is before [b], in units of a form. */
    private fun lead(a: LinearForm, b: LinearForm, x: Int): Long {
        counters.depthEvaluations += 2
        return if (isReverse) a.at(x, y) - b.at(x, y) else b.at(x, y) - a.at(x, y)
    }

    private fun nearer(newer: Int, older: Int, a: LinearForm?, b: LinearForm?, x: Int): Int {
        counters.depthEvaluations += 2
        val first = upper(newer, a, x)
        val second = upper(older, b, x)
        return if (first < second || (first == second && wins(newer, older))) newer else older
    }

    private fun upper(owner: Int, form: LinearForm?, x: Int): Int {
        val depth = if (form != null) (form.at(x, y) shr 32).toInt() else frame.primitives[owner].depth(x, y)
        return (test.key(depth, 0) ushr 32).toInt()
    }

    private fun run(end: Int, owner: Int) {
        if (runs > 0 && runOwners[runs - 1] == owner) {
            runEnds[runs - 1] = end
            return
        }
        if (runs == runEnds.size) {
            runEnds = runEnds.copyOf(2 * runs)
            runOwners = runOwners.copyOf(2 * runs)
        }
        runEnds[runs] = end
        runOwners[runs++] = owner
    }

    private companion object {
        const val FIRST = 32
        const val UNIT = 1L shl 32
    }
}
