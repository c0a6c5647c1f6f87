package dev.lazyz.conformance.strangers5

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.SpanCursor

/** The primitives that may cover something of the current row, from near to far by their bounds. */
internal class CasterActive(private val frame: Frame, private val mistake: Mistake?) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val isReverse = test.isReverse()

    /** Rows and indices of those that have not begun, in ascending order. */
    private val waiting: LongArray
    private var begun = 0

    /** Number of active primitives. */
    var count: Int = 0
        private set

    /** The least key that a fragment of an active primitive may have; its index is in it. */
    var near: LongArray = LongArray(8)
        private set
    private var cursors = arrayOfNulls<SpanCursor>(8)
    private val byObject = java.util.IdentityHashMap<Primitive, SpanCursor>()

    /** Depth forms' values at the first column, kept for level forms. */
    private var levels = LongArray(8)

    init {
        var starts = LongArray(8)
        var size = 0
        for ((index, primitive) in frame.primitives.withIndex()) {
            if (!primitive.meets(region)) continue
            if (size == starts.size) starts = starts.copyOf(2 * size)
            starts[size++] = maxOf(primitive.rowStart, region.rowStart).toLong() shl 32 or index.toLong()
        }
        waiting = starts.copyOf(size)
        waiting.sort()
    }

    /** Bytes held. */
    val bytes: Long get() = 8L * waiting.size + 24L * near.size

    /** Goes to row [y], the next one. */
    fun moveTo(y: Int) {
        var kept = 0
        for (i in 0 until count) {
            if (primitive(i).rowEnd <= y) continue
            near[kept] = near[i]
            cursors[kept] = cursors[i]
            levels[kept++] = levels[i]
        }
        cursors.fill(null, kept, count)
        count = kept
        while (begun < waiting.size && (waiting[begun] ushr 32).toInt() <= y) begin(waiting[begun++].toInt(), y)
    }

    private fun begin(index: Int, y: Int) {
        val primitive = frame.primitives[index]
        if (count == near.size) {
            near = near.copyOf(2 * count)
            cursors = cursors.copyOf(2 * count)
            levels = levels.copyOf(2 * count)
        }
        val key = test.key(if (isReverse) primitive.greatestDepth else primitive.leastDepth, index)
        var at = count++
        while (at > 0 && near[at - 1] > key) {
            near[at] = near[at - 1]
            cursors[at] = cursors[at - 1]
            levels[at] = levels[at - 1]
            at--
        }
        near[at] = key
        cursors[at] = if (mistake == Mistake.CASTER_CURSOR_BY_OBJECT) {
            byObject.getOrPut(primitive) { primitive.cursor(y) }
        } else {
            primitive.cursor(y)
        }
        levels[at] = primitive.depthForm?.at(region.columnStart, y) ?: 0L
    }

    /** Returns the submission index of active primitive [i]. */
    fun index(i: Int): Int = test.indexOf(near[i])

    /** Returns active primitive [i]. */
    fun primitive(i: Int): Primitive = frame.primitives[index(i)]

    /** Returns the cursor of active primitive [i]. */
    fun cursor(i: Int): SpanCursor = checkNotNull(cursors[i])

    /** Returns what the form of active primitive [i] was at its first row. */
    fun level(i: Int): Long = levels[i]
}
