package dev.lazyz.spi

/**
 * The spans of one row: half-open ranges of columns, [start] until [end].
 *
 * A reusable list. It grows as needed and never shrinks. Not thread safe.
 *
 * @property columnStart columns before this one are dropped by [add]
 * @property columnEnd columns from this one on are dropped by [add]
 */
public class Spans @JvmOverloads constructor(
    public val columnStart: Int = 0,
    public val columnEnd: Int = Int.MAX_VALUE,
) {
    private var bounds = IntArray(16)

    /** Number of spans. */
    public var count: Int = 0
        private set

    /** Bytes of the list at its current capacity. */
    internal val bytes: Long get() = Int.SIZE_BYTES * bounds.size.toLong()

    /** First column of span [i]. */
    public fun start(i: Int): Int = bounds[2 * i]

    /** The column after the last of span [i]. */
    public fun end(i: Int): Int = bounds[2 * i + 1]

    /**
     * Appends the columns [from] until [until], clipped to [columnStart] until [columnEnd]. Adds nothing if the result
     * is empty, also if [until] is less than [from]. A span that starts where the last one ends extends it.
     *
     * @throws IllegalArgumentException if the result starts before the end of the last span: spans are added from left
     *   to right, without overlap
     */
    public fun add(from: Int, until: Int) {
        val start = maxOf(from, columnStart)
        val end = minOf(until, columnEnd)
        if (start >= end) return
        if (count > 0 && start <= bounds[2 * count - 1]) {
            if (start < bounds[2 * count - 1]) throw disorder(start, end)
            bounds[2 * count - 1] = end
            return
        }
        if (2 * count == bounds.size) bounds = bounds.copyOf(bounds.size * 2)
        bounds[2 * count] = start
        bounds[2 * count + 1] = end
        count++
    }

    private fun disorder(start: Int, end: Int) = IllegalArgumentException(
        "spans must be added from left to right, without overlap: $start..<$end comes after " +
            "${start(count - 1)}..<${end(count - 1)}",
    )

    /** Removes all spans. */
    public fun clear() {
        count = 0
    }

    override fun toString(): String = (0 until count).joinToString(prefix = "[", postfix = "]") {
        "${start(it)}..<${end(it)}"
    }
}

/**
 * Incremental shading: carries state from sample to sample along a row. Used by one thread.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 4.
 */
public interface ShadingCursor {
    /**
     * Moves to the next column. Less expensive than a direct evaluation; `Primitive.shadingStartCost` gives the ratio.
     */
    public fun step()

    /** Computes the colour at the current column. [fragment] has already been moved there. */
    public fun shade(fragment: Fragment)
}

/** Returns the spans of a primitive row by row, downward. Used by one thread. */
public fun interface SpanCursor {
    /** Replaces the contents of [spans] with the spans of the current row, then moves to the next row. */
    public fun next(spans: Spans)
}

/**
 * Observes the shading calls of a rendering: which samples are shaded, how often, and in which order. See
 * `Frame.observed`.
 *
 * It is called before a colour is computed, by the threads of the renderer, several at the same time if the renderer
 * uses several; so it must be thread safe, or the renderer be configured with one thread.
 */
public fun interface ShadingObserver {
    /** The primitive with the submission index [primitive] is about to be shaded at column [x] and row [y]. */
    public fun shading(x: Int, y: Int, primitive: Int)
}
