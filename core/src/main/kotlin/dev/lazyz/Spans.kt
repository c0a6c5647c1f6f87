package dev.lazyz

/**
 * The spans of one row: half-open runs of columns, [start] until [end].
 *
 * A reusable list; not thread safe. Grows as needed and never shrinks.
 */
public class Spans {
    private var bounds = IntArray(16)

    /** Number of spans. */
    public var count: Int = 0
        private set

    /** First column of span [i]. */
    public fun start(i: Int): Int = bounds[2 * i]

    /** Column after the last of span [i]. */
    public fun end(i: Int): Int = bounds[2 * i + 1]

    /**
     * Appends the columns [start] until [end]; a span that touches the last one extends it. The caller keeps spans in
     * order, not empty and not overlapping.
     */
    public fun add(start: Int, end: Int) {
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

    override fun toString(): String = (0 until count).joinToString(prefix = "[", postfix = "]") { "${start(it)}..<${end(it)}" }
}
