package dev.lazyz.raster

import dev.lazyz.Checkpoint

/**
 * Sorts the keys at the indices [from] until [until] in ascending order, and passes [checkpoint] at least once for each
 * [AT_ONCE] of them. More keys than that are divided as quicksort does, the parts are sorted by the JDK.
 */
internal fun LongArray.sortKeys(checkpoint: Checkpoint, from: Int = 0, until: Int = size) {
    sortKeys(checkpoint, from, until, MOST_DIVISIONS)
}

private fun LongArray.sortKeys(checkpoint: Checkpoint, from: Int, until: Int, divisions: Int) {
    checkpoint.pass()
    if (until - from <= AT_ONCE || divisions == 0) return sort(from, until)
    val middle = divide(from, until)
    sortKeys(checkpoint, from, middle, divisions - 1)
    sortKeys(checkpoint, middle, until, divisions - 1)
}

/** Moves lesser keys before greater ones. Returns the index that divides them, which is neither of the bounds. */
private fun LongArray.divide(from: Int, until: Int): Int {
    val step = (until - from) / SAMPLE
    val pivot = LongArray(SAMPLE) { this[from + it * step] }.apply { sort() }[SAMPLE / 2]
    var low = from - 1
    var high = until
    while (true) {
        do low++ while (this[low] < pivot)
        do high-- while (this[high] > pivot)
        if (low >= high) return if (high + 1 < until) high + 1 else high
        val key = this[low]
        this[low] = this[high]
        this[high] = key
    }
}

/** Most keys that are sorted without a checkpoint: some 20 ms. */
private const val AT_ONCE = 1 shl 18

/** After so many divisions, the keys are such that they do not become fewer. */
private const val MOST_DIVISIONS = 40

/** The number of keys whose median divides all. */
private const val SAMPLE = 33
