package dev.lazyz.drawing

/** Parts of the range 0..1, as pairs of numbers. A reusable list; not thread safe. */
internal class Intervals {
    private var bounds = DoubleArray(32)

    /** Number of parts. */
    var count: Int = 0
        private set

    fun from(i: Int): Double = bounds[2 * i]

    fun until(i: Int): Double = bounds[2 * i + 1]

    fun clear() {
        count = 0
    }

    fun add(from: Double, until: Double) {
        if (2 * count == bounds.size) bounds = bounds.copyOf(2 * bounds.size)
        bounds[2 * count] = from
        bounds[2 * count + 1] = until
        count++
    }

    /** Sorts the parts, and joins those that overlap or touch. */
    fun join() {
        sort()
        var last = 0
        for (i in 1 until count) {
            if (bounds[2 * i] <= bounds[2 * last + 1]) {
                bounds[2 * last + 1] = maxOf(bounds[2 * last + 1], bounds[2 * i + 1])
            } else {
                last++
                bounds[2 * last] = bounds[2 * i]
                bounds[2 * last + 1] = bounds[2 * i + 1]
            }
        }
        count = minOf(count, last + 1)
    }

    private fun sort() {
        if (count < 2) return
        val order = (0 until count).sortedBy { bounds[2 * it] }
        bounds = DoubleArray(bounds.size) { if (it < 2 * count) bounds[2 * order[it / 2] + it % 2] else 0.0 }
    }

    /** Calls [action] for each part of [from]..[until] that is in none of these parts, which have been joined. */
    inline fun forEachGap(from: Double, until: Double, action: (from: Double, until: Double) -> Unit) {
        var at = from
        for (i in 0 until count) {
            if (from(i) > at) action(at, minOf(from(i), until))
            at = maxOf(at, until(i))
            if (at >= until) return
        }
        if (at < until) action(at, until)
    }
}
