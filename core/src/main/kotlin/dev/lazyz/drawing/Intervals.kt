package dev.lazyz.drawing

/** The part of an edge that linear conditions leave: from [low] to [high], 0 for its first end and 1 for its second. */
internal class KeptPart {
    var low = 0.0
        private set
    var high = 1.0
        private set

    val isEmpty: Boolean get() = low >= high

    /** Keeps the whole edge. */
    fun begin() {
        low = 0.0
        high = 1.0
    }

    /** Keeps nothing. */
    fun clear() {
        high = low
    }

    /** Keeps the part in which a linear function with the values [f0] and [f1] at the ends is not negative. */
    fun keepPositive(f0: Double, f1: Double) {
        if (f0 < 0.0) {
            if (f1 < 0.0) clear() else low = maxOf(low, f0 / (f0 - f1))
        } else if (f1 < 0.0) {
            high = minOf(high, f0 / (f0 - f1))
        }
    }
}

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

    /**
     * Sets these to the parts that more than [most] of the parts of [all] contain, joined. Neighbours on a surface
     * overlap by rounding, or leave a gap: what is not longer than [HiddenParts.LEAST_PART] does not count.
     */
    fun setDeep(all: Intervals, most: Int) {
        clear()
        val starts = DoubleArray(all.count) { all.from(it) }.apply { sort() }
        val ends = DoubleArray(all.count) { all.until(it) }.apply { sort() }
        for (i in most until all.count) {
            // From here on, i + 1 parts have begun, and until there, fewer than i + 1 - most have ended
            val start = starts[i]
            val end = ends[i - most]
            if (end - start <= HiddenParts.LEAST_PART) continue
            if (count > 0 && start - until(count - 1) <= HiddenParts.LEAST_PART) {
                bounds[2 * count - 1] = end
            } else {
                add(start, end)
            }
        }
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
