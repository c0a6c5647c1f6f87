package dev.lazyz.pipeline

import dev.lazyz.Coherence
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Spans
import dev.lazyz.raster.reaches

/**
 * The stages through which rows run, in submission order: one for each primitive that is alive on the current row.
 *
 * A stage joins at its primitive's first row within the region and leaves after the last, so what is retained follows the
 * primitives alive on a row and not the number of rows; besides there are 8 bytes for each primitive of the region,
 * sorted by first row. A pipeline runs each row through the chain from upstream to downstream:
 *
 *     var row = chain.begin(y)
 *     for (i in 0 until chain.size) row = chain[i].next(row)
 *     chain.end(row)
 *
 * Belongs to one thread.
 *
 * @param stage makes a stage of a primitive's index and the first row it will see
 */
internal class Chain(
    private val frame: Frame,
    private val coherence: Coherence,
    private val stage: (Frame, Int, Int, Spans) -> Stage,
) {
    /** What is still to join: first row and index in one word, sorted. */
    private val entries = entries(frame)
    private var entered = 0

    /** The chain, from upstream to downstream; null from [size] on. */
    private var stages = arrayOfNulls<Stage>(CAPACITY)
    private var stageBytes = 0L
    private val spans = Spans(frame.region)

    /** Number of stages. */
    var size: Int = 0
        private set

    operator fun get(i: Int): Stage = stages[i]!!

    /** Begins row [y]: stages join whose primitives begin here. Returns what the first stage takes: a row of background. */
    fun begin(y: Int): Row {
        join(y)
        val row = Row(frame, y, coherence)
        if (y == frame.region.rowStart) row.counters.primitives = frame.primitives.size.toLong()
        return row
    }

    /** Ends [row], as it came from the last stage: stages leave whose primitives end here. */
    fun end(row: Row) {
        row.counters.peakSuspensions = row.keys.count { row.test.indexOf(it) != DepthTest.BACKGROUND }.toLong()
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

        // Two runs in submission order become one: to a merge sort this is a merge
        if (before in 1 until size && get(before - 1).index > get(before).index) {
            java.util.Arrays.sort(stages, 0, size, BY_INDEX)
        }
    }

    private fun leave(y: Int) {
        // Close up to the stages that go on
        var kept = 0
        for (i in 0 until size) {
            val stage = get(i)
            if (stage.rowEnd > y + 1) stages[kept++] = stage else stageBytes -= stage.bytes
        }
        stages.fill(null, kept, size)
        size = kept

        // Give back the room of a crowd that has left
        if (stages.size > CAPACITY && stages.size / 4 >= size) stages = stages.copyOf(maxOf(CAPACITY, 2 * size))
    }

    private companion object {
        const val CAPACITY = 16

        /** Of a Java heap beyond 32 gigabytes; half as much below. */
        const val REFERENCE_BYTES = 8L

        val BY_INDEX = Comparator<Stage?> { a, b -> a!!.index.compareTo(b!!.index) }

        /** Finds the primitives that may cover samples of the region, and sorts them by first row, then by index. */
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
