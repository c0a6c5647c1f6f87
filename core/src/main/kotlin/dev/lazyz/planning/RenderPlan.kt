package dev.lazyz.planning

import dev.lazyz.Renderer
import dev.lazyz.strategies.StrategyEstimates

/**
 * How to render a picture in limited memory, and what that needs. Made by [RenderPlanner]. Immutable.
 *
 * @property renderer the renderer, configured with threads, tiles, bands and budget of this plan
 * @property memory bytes of memory that may be used
 * @property items what each part needs
 * @property passes how many times the primitives are read: once, or, if they are streamed, once for each band of rows;
 *   more often if a band has too many translucent fragments
 * @property summary the strategy and its options, in words
 */
public class RenderPlan internal constructor(
    public val renderer: Renderer,
    public val memory: Long,
    public val items: List<RenderPlan.Item>,
    public val passes: Int,
    public val summary: String,
) {
    /** What all [items] need together, in bytes. */
    public val bytes: Long = items.sumOf { it.bytes }

    /**
     * The smallest memory with which this plan fits, in bytes: that of the [items], and a reserve. The garbage
     * collector needs free memory to work, and divides memory into parts that cannot be filled completely.
     */
    public val leastMemory: Long = leastMemory(bytes)

    /** Whether the [memory] is enough. */
    public val fits: Boolean get() = leastMemory <= memory

    /** Returns readable text: a line for each item, the reserve, the sum, and the [summary]. */
    public fun explain(): String = buildString {
        append("memory: ${mebibytes(memory)} may be used\n")
        val all = items + RenderPlan.Item("reserve for the garbage collector", reserve(bytes)) +
            RenderPlan.Item("all", leastMemory)
        for (item in all) append("  %-52s %12s\n".format(null, item.what, mebibytes(item.bytes)))
        append("plan: $summary\n")
    }

    override fun toString(): String = "RenderPlan($summary, $leastMemory of $memory bytes)"

    /**
     * What a part of a rendering needs. Immutable.
     *
     * @property what description of the part
     * @property bytes most bytes of memory that it holds at a time
     * @throws IllegalArgumentException if [bytes] is negative
     */
    public class Item(public val what: String, public val bytes: Long) {
        init {
            require(bytes >= 0) { "bytes must not be negative: $bytes" }
        }

        override fun toString(): String = "Item($what, $bytes bytes)"
    }

    public companion object {
        /** Part of the need that is kept free in addition, one in so many. Measured, see docs/memory.md. */
        private const val RESERVE_PART = 3
        private const val LEAST_RESERVE = 4L shl 20

        /** Returns the memory with which objects of so many [bytes] fit, with a reserve. */
        @JvmStatic
        public fun leastMemory(bytes: Long): Long = bytes + reserve(bytes)

        private fun reserve(bytes: Long): Long = bytes / RESERVE_PART + LEAST_RESERVE

        /** Returns how many bytes items can need with [memory] bytes; negative if there is not even the reserve. */
        internal fun usable(memory: Long): Long = (memory - LEAST_RESERVE) / (RESERVE_PART + 1) * RESERVE_PART

        internal fun mebibytes(bytes: Long): String = StrategyEstimates.mebibytes(bytes.toDouble())
    }
}
