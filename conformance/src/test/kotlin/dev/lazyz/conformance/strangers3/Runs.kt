package dev.lazyz.conformance.strangers3

import dev.lazyz.Counters
import dev.lazyz.Frame

/** A row's runs of one primitive each, from left to right, not overlapping. */
internal class Runs(private val mistake: Mistake?) {
    private var values = IntArray(24)

    var count = 0
        private set

    val bytes: Long get() = 4L * values.size

    fun start(i: Int): Int = values[3 * i]

    fun end(i: Int): Int = values[3 * i + 1]

    fun index(i: Int): Int = values[3 * i + 2]

    fun clear() {
        count = 0
    }

    fun add(start: Int, end: Int, index: Int) {
        if (start >= end) return
        val at = 3 * count
        val reach = if (mistake == Mistake.SPANS_JOINS_GAPS) 1 else 0
        if (count > 0 && values[at - 1] == index && start - values[at - 2] <= reach) {
            values[at - 2] = end
            return
        }
        if (at == values.size) values = values.copyOf(2 * at)
        values[at] = start
        values[at + 1] = end
        values[at + 2] = index
        count++
    }
}

/** Decides between two lists of runs. */
internal class Contest(
    private val frame: Frame,
    private val counters: Counters.Builder,
    private val mistake: Mistake?
) {
    private val test = frame.raster.depthTest
    private val isReversed = test.key(1, 0) < test.key(0, 0)

    fun merge(a: Runs, b: Runs, y: Int, out: Runs) {
        var i = 0
        var j = 0
        var at = 0
        while (i < a.count || j < b.count) {
            val left = if (i < a.count) maxOf(a.start(i), at) else Int.MAX_VALUE
            val right = if (j < b.count) maxOf(b.start(j), at) else Int.MAX_VALUE
            if (left < right) {
                at = minOf(a.end(i), right)
                out.add(left, at, a.index(i))
            } else if (right < left) {
                at = minOf(b.end(j), left)
                out.add(right, at, b.index(j))
            } else {
                at = minOf(a.end(i), b.end(j))
                both(left, at, y, a.index(i), b.index(j), out)
            }
            while (i < a.count && a.end(i) <= at) i++
            while (j < b.count && b.end(j) <= at) j++
        }
    }

    private fun both(start: Int, end: Int, y: Int, a: Int, b: Int, out: Runs) {
        val winner = everywhere(start, end, y, a, b)
        if (winner >= 0) {
            out.add(start, end, winner)
            return
        }
        for (x in start until end) {
            val isFirst = key(x, y, a) < key(x, y, b)
            out.add(x, x + 1, if (isFirst) a else b)
        }
    }

    /** The one that is visible all along, as far as the ends tell, or -1. */
    private fun everywhere(start: Int, end: Int, y: Int, a: Int, b: Int): Int {
        if (mistake == Mistake.SPANS_ENDS_DECIDE) {
            val isFirst = key(start, y, a) < key(start, y, b)
            return if (isFirst == key(end - 1, y, a) < key(end - 1, y, b)) (if (isFirst) a else b) else -1
        }
        val first = frame.primitives[a].depthForm ?: return -1
        val second = frame.primitives[b].depthForm ?: return -1
        counters.depthEvaluations += 4
        val sign = if (isReversed) -1 else 1
        val lead = sign * (second.at(start, y) - first.at(start, y))
        val other = sign * (second.at(end - 1, y) - first.at(end - 1, y))
        val winsTies = test.key(0, a) < test.key(0, b) || mistake == Mistake.SPANS_LEAD_OF_ZERO
        if (minOf(lead, other) >= if (winsTies) 0 else UNIT) return a
        if (minOf(-lead, -other) >= if (winsTies) UNIT else 0) return b
        return -1
    }

    private fun key(x: Int, y: Int, index: Int): Long {
        counters.depthEvaluations++
        return test.key(frame.primitives[index].depthAt(x, y), index)
    }

    private companion object {
        const val UNIT = 1L shl 32
    }
}
