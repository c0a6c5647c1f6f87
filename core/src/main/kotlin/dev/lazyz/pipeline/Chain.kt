package dev.lazyz.pipeline

import dev.lazyz.Coherence
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Spans
import dev.lazyz.raster.reaches

/**
 * The stages that rows pass through, in submission order: one for each primitive that can cover the current row.
 *
 * A stage is added at the first row of its primitive within the region, and removed after the last. So memory depends
 * on the number of primitives on a row, not on the number of rows; in addition there are 8 bytes for each primitive of
 * the region, sorted by first row. A pipeline passes each row through the chain from upstream to downstream:
 *
 *     var row = chain.begin(y)
 *     for (i in 0 until chain.size) row = chain[i].next(row)
 *     chain.end(row)
 *
 * Used by one thread.
 *
 * @param stage creates the stage of a primitive from the frame, the primitive's index, the first row that the stage
 *   will receive, and scratch memory for spans
 */
internal class Chain(
    private val frame: Frame,
    private val coherence: Coherence,
    private val stage: (Frame, Int, Int, Spans) -> Stage,
) {
    /**
     * Primitives of the region: first row and index in one word, sorted. Those before [entered] have already been
     * added.
     */
    private val entries = entries(frame)
    private var entered = 0

    /** The stages, from upstream to downstream; null from [size] on. */
    private var stages = arrayOfNulls<Stage>(CAPACITY)
    private var stageBytes = 0L
    private val spans = Spans(frame.region)

    /** Number of stages. */
    var size: Int = 0
        private set

    operator fun get(i: Int): Stage = stages[i]!!

    /**
     * Begins row [y]: adds the stages whose primitives begin here. Returns the input of the first stage: a row of
     * background.
     */
    fun begin(y: Int): Row {
        join(y)
        val row = Row(frame, y, coherence)
        if (y == frame.region.rowStart) row.counting.primitives = frame.primitives.size.toLong()
        return row
    }

    /** Ends [row], the output of the last stage: removes the stages whose primitives end here. */
    fun end(row: Row) {
        row.counting.peakSuspensions = row.keys.count { row.test.indexOf(it) != DepthTest.BACKGROUND }.toLong()
        row.hold(Long.SIZE_BYTES * entries.size + REFERENCE_BYTES * stages.size + stageBytes + spans.bytes)
        leave(row.y)
    }

    private fun join(y: Int) {
        val before = size
        while (entered < entries.size && (entries[entered] ushr 32).toInt() <= y) {
            if (size == stages.size) stages = stages.copyOf(2 * size)
            val joining = stage(frame, entries[entered++].toInt(), y, spans)
            stages[size++] = joining
            stageBytes += joining.bytes
        }

        // Two sequences in submission order become one; merge sort does this in linear time
        if (before in 1 until size && get(before - 1).index > get(before).index) {
            java.util.Arrays.sort(stages, 0, size, BY_INDEX)
        }
    }

    private fun leave(y: Int) {
        // Keep the stages that continue, without gaps
        var kept = 0
        for (i in 0 until size) {
            val stage = get(i)
            if (stage.rowEnd > y + 1) stages[kept++] = stage else stageBytes -= stage.bytes
        }
        stages.fill(null, kept, size)
        size = kept

        // Shrink the array if most stages have been removed
        if (stages.size > CAPACITY && stages.size / 4 >= size) stages = stages.copyOf(maxOf(CAPACITY, 2 * size))
    }

    private companion object {
        const val CAPACITY = 16

        /** Bytes of a reference in a Java heap larger than 32 gigabytes; it is half as much in smaller heaps. */
        const val REFERENCE_BYTES = 8L

        val BY_INDEX = Comparator<Stage?> { a, b -> a!!.index.compareTo(b!!.index) }

        /** Finds the primitives that can cover samples of the region, and sorts them by first row, then by index. */
        fun entries(frame: Frame): LongArray {
            val region = frame.region
            val all = LongArray(frame.primitives.size)
            var count = 0
            for ((index, primitive) in frame.primitives.withIndex()) {
                if (!primitive.reaches(region)) continue
                all[count++] = maxOf(primitive.rowStart, region.rowStart).toLong() shl 32 or index.toLong()
            }
            all.sort(0, count)
            return if (count == all.size) all else all.copyOf(count)
        }
    }
}
