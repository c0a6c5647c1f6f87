package dev.lazyz.raster

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.FrameContent
import dev.lazyz.Primitive

/**
 * The order of fragments of a [DepthTest], applied to whole primitives: to their bounds, and to linear forms.
 *
 * Used by renderers that decide visibility for many samples at once. Immutable and thread safe.
 *
 * The following shows why comparing two samples decides all samples between them. Let the forms of two primitives have
 * the values f and b at a sample that both cover. The *lead* of the first is b - f (f - b if the greatest depth wins).
 * Depth is the value without its lower 32 bits, rounded down; ties are resolved by submission index. So, at one sample:
 *
 * - lead >= 0 implies that the first is not behind the second, because rounding down keeps the order (and if the
 *   greatest depth wins, depths compare like their values, in reverse). If the first also wins ties, it is visible.
 * - lead >= 2^32 implies that the first is at least one unit in front of the second, whichever wins ties.
 *
 * This is [leastLead]. The lead of two linear forms is a linear form, so its minimum over consecutive samples of a row
 * is at an end, and over a convex set of samples at a corner. If the lead is at least [leastLead] there, it is so
 * everywhere, and the first primitive is visible everywhere. Nothing wraps around: at covered samples a value is in 0
 * until 2^63, so the difference of two is exact in 64 bits. The value at a covered sample plus a step to a covered
 * neighbour is exact too, because two numbers below 2^63 that are equal modulo 2^64 are equal.
 */
internal class VisibilityOrder(private val test: DepthTest) {
    /** Whether the greatest depth wins. */
    private val isReversed = test.key(1, 0) < test.key(0, 0)

    /** Returns a lower bound of the keys of all fragments of [primitive]. */
    fun nearestKey(primitive: Primitive, index: Int): Long =
        test.key(if (isReversed) primitive.greatestDepth else primitive.leastDepth, index)

    /** As the other [nearestKey], for the primitive [index] of [content], without making an object of it. */
    fun nearestKey(content: FrameContent, index: Int): Long {
        val number = content.batchNumber(index)
        if (number < 0) return nearestKey(content.single(index), index)
        val batch = content.batches[number]
        val triangle = index - batch.first
        return test.key(if (isReversed) batch.greatestDepth(triangle) else batch.leastDepth(triangle), index)
    }

    /** Returns an upper bound of the keys of all fragments of [primitive]. */
    fun farthestKey(primitive: Primitive, index: Int): Long =
        test.key(if (isReversed) primitive.leastDepth else primitive.greatestDepth, index)

    /** Returns the key of a fragment of primitive [index] at a sample where its form has the value [value]. */
    fun key(value: Long, index: Int): Long = test.key((value shr 32).toInt(), index)

    /**
     * Returns how far the value [front] of one form is in front of the value [behind] of another, at a sample that both
     * cover.
     */
    fun lead(front: Long, behind: Long): Long = if (isReversed) front - behind else behind - front

    /** Returns the smallest lead that implies that primitive [front] is visible in front of primitive [behind]. */
    fun leastLead(front: Int, behind: Int): Long = if (test.key(0, front) < test.key(0, behind)) 0 else UNIT

    private companion object {
        /** One unit of depth in a linear form, which has 32 fraction bits. */
        const val UNIT = 1L shl 32
    }
}

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
