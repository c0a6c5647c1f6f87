package dev.lazyz.pipeline

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.bytes
import dev.lazyz.raster.byFirstRow
import dev.lazyz.raster.bytes
import dev.lazyz.raster.forEachKey
import dev.lazyz.raster.forEachPrimitive
import dev.lazyz.raster.reaches
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.Spans

/**
 * The stages that rows pass through, in submission order: one for each primitive that can cover the current row.
 *
 * A stage is added at the first row of its primitive within the region, and removed after the last. So memory depends
 * on the number of primitives on a row, not on the number of rows; in addition there are 8 bytes for each primitive of
 * the region, sorted by first row.
 *
 * With a budget, a stage is added only if it fits, and the list of primitives is kept only if it fits. A primitive
 * without a stage is drawn at the beginning of each of its rows, by a stage that is made for this row and then dropped.
 *
 * Used by one thread.
 *
 * @param checkpoint passed for each row and each primitive on it, also while they are sorted
 * @param stage creates the stage of a primitive from the frame, the primitive's index, the first row that the stage
 *   will receive, and scratch memory for spans
 * @param budget most bytes to hold in addition to what a frame without primitives takes, or null for no limit
 */
internal class Chain(
    private val frame: Frame,
    coherence: Coherence,
    private val checkpoint: Checkpoint,
    private val stage: (Frame, Int, Int, Spans) -> Stage,
    private val budget: Long? = null,
) {
    /** The budget also holds the state of incremental shading; without room for it, rows are shaded directly. */
    private val coherence =
        if (budget == null || LateShading.mostBytes(frame) <= budget) coherence else Coherence.DIRECT
    private val shadingBytes = if (this.coherence == Coherence.DIRECT) 0L else LateShading.mostBytes(frame)

    /**
     * Primitives of the region: first row and index in one word, sorted; null if they do not fit into the budget. The
     * sign bit is set once a primitive needs no stage any more, because it has one or has ended. This is so for those
     * before [settled]. The rows of those before [entered] have begun.
     */
    private val entries: LongArray? = entries()
    private val entryBytes = entries?.bytes ?: 0
    private var settled = 0
    private var entered = 0

    /** The stages, from upstream to downstream; null from [size] on. */
    private var stages = arrayOfNulls<Stage>(CAPACITY)
    private var stageBytes = 0L
    private val spans = frame.region.spans()

    /** Bytes of [spans]. With a budget, these are the most that it can grow to, whatever the primitives are. */
    private val spansBytes: Long
        get() = if (budget == null) spans.bytes else maxOf(spans.bytes, Long.SIZE_BYTES * (frame.width + 1L))

    /** Number of stages. */
    var size: Int = 0
        private set

    operator fun get(i: Int): Stage = stages[i]!!

    /** Passes row [y], the one after the last, through the stages, from upstream to downstream, and returns it. */
    fun row(y: Int): LazyRow {
        checkpoint.pass()
        var row = begin(y)
        for (i in 0 until size) {
            checkpoint.pass()
            row = get(i).next(row)
        }
        end(row)
        return row
    }

    /**
     * Begins row [y]: adds the stages whose primitives begin here. Returns the input of the first stage: a row of
     * background, on which only the primitives without a stage are drawn.
     */
    fun begin(y: Int): LazyRow {
        val row = LazyRow(frame, y, coherence)
        if (y == frame.region.rowStart) row.counting.primitives = frame.primitives.size.toLong()
        if (entries != null) join(entries, row) else drawAll(row)
        return row
    }

    /** Ends [row], the output of the last stage: removes the stages whose primitives end here. */
    fun end(row: LazyRow) {
        row.counting.peakSuspensions = row.keys.count { row.test.indexOf(it) != DepthTest.BACKGROUND }.toLong()
        row.hold(entryBytes + stages.bytes + stageBytes + spansBytes)
        leave(row.y)
    }

    private fun join(entries: LongArray, row: LazyRow) {
        val y = row.y
        val before = size
        while (entered < entries.size && (entries[entered] ushr 32).toInt() <= y) entered++
        for (i in settled until entered) {
            checkpoint.pass()
            if (entries[i] < 0) continue
            val index = entries[i].toInt()
            val hasEnded = frame.primitives[index].rowEnd <= y
            if (hasEnded || !isStageless(index, row)) entries[i] = entries[i] or Long.MIN_VALUE
        }
        while (settled < entered && entries[settled] < 0) settled++

        // Two sequences in submission order become one; merge sort does this in linear time
        if (before in 1 until size && get(before - 1).index > get(before).index) {
            java.util.Arrays.sort(stages, 0, size, BY_INDEX)
        }
    }

    /**
     * Adds a stage for the primitive [index]. If the stage does not fit into the budget, draws [row] instead, and
     * returns true.
     */
    private fun isStageless(index: Int, row: LazyRow): Boolean {
        val joining = stage(frame, index, row.y, spans)
        if (!hasRoom(joining.bytes)) {
            joining.next(row)
            return true
        }
        if (size == stages.size) stages = stages.copyOf(2 * size)
        stages[size++] = joining
        stageBytes += joining.bytes
        return false
    }

    /** Whether a stage of [bytes] fits into the budget. While the array of stages is replaced, both are counted. */
    private fun hasRoom(bytes: Long): Boolean {
        if (budget == null) return true
        val capacity = if (size == stages.size) 3 * size else stages.size
        val held = shadingBytes + entryBytes + stageBytes
        return bytes + HeapLayout.REFERENCE * (capacity - CAPACITY) <= budget - held
    }

    /** Draws all primitives of the row, without stages. */
    private fun drawAll(row: LazyRow) {
        frame.forEachPrimitive(checkpoint) { index, primitive ->
            if (row.y in primitive.rowStart until primitive.rowEnd && primitive.reaches(frame.region)) {
                stage(frame, index, row.y, spans).next(row)
            }
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

    private fun entries(): LongArray? {
        var count = 0L
        if (budget != null) {
            frame.forEachPrimitive(checkpoint) { _, primitive -> if (primitive.reaches(frame.region)) count++ }
            if (Long.SIZE_BYTES * count > budget - shadingBytes) return null
        }
        return frame.byFirstRow(checkpoint)
    }

    private companion object {
        const val CAPACITY = 16

        val BY_INDEX = Comparator<Stage?> { a, b -> a!!.index.compareTo(b!!.index) }
    }
}

/**
 * A primitive as a transformation of rows: takes the upstream row, whose cells show all earlier primitives, and returns
 * the downstream row, whose cells show those and this primitive.
 *
 * Upstream does not use a row after passing it on, so the row is changed in place.
 *
 * @property index submission index of the primitive
 * @param y first row that the stage will receive; the others follow in order
 * @param spans scratch memory for the spans of a row, shared by the stages of a chain
 */
internal open class Stage(frame: Frame, val index: Int, y: Int, private val spans: Spans) {
    private val primitive = frame.primitives[index]
    private val cursor = primitive.cursor(y)
    private val firstColumn = frame.region.columnStart

    /** The row after the last row that this stage must receive. */
    val rowEnd: Int = minOf(primitive.rowEnd, frame.region.rowEnd)

    /** Bytes of this stage. */
    open val bytes: Long get() = HeapLayout.STAGE + cursor.bytes

    /** Receives the next row from upstream and returns the row for downstream. */
    open fun next(upstream: LazyRow): LazyRow = transform(upstream)

    /** Lowers the keys of the cells of [row] in which this primitive is visible. */
    protected fun transform(row: LazyRow): LazyRow {
        cursor.next(spans)
        for (i in 0 until spans.count) drawSpan(row, spans.start(i), spans.end(i))
        return row
    }

    private fun drawSpan(row: LazyRow, start: Int, end: Int) {
        val keys = row.keys
        var passes = 0L
        primitive.forEachKey(index, row.test, row.y, start, end) { x, key ->
            if (key < keys[x - firstColumn]) {
                keys[x - firstColumn] = key
                passes++
            }
        }
        row.counting.fragments += end - start
        row.counting.depthEvaluations += end - start
        row.counting.depthPasses += passes
    }
}
