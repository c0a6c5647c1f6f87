package dev.lazyz

/**
 * The spans of one row: half-open runs of columns, [start] until [end].
 *
 * A reusable list; not thread safe. Grows as needed and never shrinks.
 *
 * @property columnStart columns before this one are dropped as they are added
 * @property columnEnd columns from this one on are dropped as they are added
 */
public class Spans @JvmOverloads constructor(
    public val columnStart: Int = 0,
    public val columnEnd: Int = Int.MAX_VALUE,
) {
    /** Spans that keep the columns of [region]. */
    public constructor(region: Region) : this(region.columnStart, region.columnEnd)

    private var bounds = IntArray(16)

    /** Number of spans. */
    public var count: Int = 0
        private set

    /** Bytes that the list holds, grown as it is. */
    internal val bytes: Long get() = Int.SIZE_BYTES * bounds.size.toLong()

    /** First column of span [i]. */
    public fun start(i: Int): Int = bounds[2 * i]

    /** Column after the last of span [i]. */
    public fun end(i: Int): Int = bounds[2 * i + 1]

    /**
     * Appends the columns [from] until [until], as far as they are kept; nothing if none is. A span that touches the
     * last one extends it. The caller adds spans from left to right, not overlapping.
     */
    public fun add(from: Int, until: Int) {
        val start = maxOf(from, columnStart)
        val end = minOf(until, columnEnd)
        if (start >= end) return
        if (count > 0 && start == bounds[2 * count - 1]) {
            bounds[2 * count - 1] = end
            return
        }
        if (2 * count == bounds.size) bounds = bounds.copyOf(bounds.size * 2)
        bounds[2 * count] = start
        bounds[2 * count + 1] = end
        count++
    }

    /** Removes all spans. */
    public fun clear() {
        count = 0
    }

    override fun toString(): String = (0 until count).joinToString(prefix = "[", postfix = "]") {
        "${start(it)}..<${end(it)}"
    }
}
