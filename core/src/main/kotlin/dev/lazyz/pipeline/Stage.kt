package dev.lazyz.pipeline

import dev.lazyz.Frame
import dev.lazyz.Spans
import dev.lazyz.raster.TrapezoidCursor

/**
 * A primitive as a transformer of rows: takes the upstream row, in which the cells show what came before, and gives the
 * downstream row, in which they show what came before and this primitive.
 *
 * A row belongs to whoever holds it, and upstream has let go of it; so the downstream row is the upstream one, changed in
 * place.
 *
 * @property index submission index of the primitive
 * @param y first row that will come; the others follow one by one
 * @param spans room for a row's spans, shared by the stages of a chain
 */
internal open class Stage(frame: Frame, val index: Int, y: Int, private val spans: Spans) {
    private val primitive = frame.primitives[index]
    private val cursor = primitive.cursor(y)
    private val firstColumn = frame.region.columnStart

    /** The row after the last that this stage has to see. */
    val rowEnd: Int = minOf(primitive.rowEnd, frame.region.rowEnd)

    /** Bytes that this stage holds. */
    open val bytes: Long get() = BYTES + if (cursor is TrapezoidCursor) cursor.bytes else CURSOR_BYTES

    /** Takes the next row from upstream and returns it for downstream. */
    open fun next(upstream: Row): Row = transform(upstream)

    /** Lowers the cells of [row] that this primitive covers and is the visible one of. */
    protected fun transform(row: Row): Row {
        cursor.next(spans)
        for (i in 0 until spans.count) drawSpan(row, spans.start(i), spans.end(i))
        return row
    }

    private fun drawSpan(row: Row, start: Int, end: Int) {
        val test = row.test
        val keys = row.keys
        val form = primitive.depthForm
        var z = form?.at(start, row.y) ?: 0L
        val step = form?.dx ?: 0L
        var passes = 0L
        for (x in start until end) {
            // One addition a sample where depth is linear
            val depth = if (form != null) (z shr 32).toInt() else primitive.depth(x, row.y)
            z += step

            // The cell is depth and suspension in one word: the visible one is the minimum
            val key = test.key(depth, index)
            if (key < keys[x - firstColumn]) {
                keys[x - firstColumn] = key
                passes++
            }
        }
        row.counters.fragments += end - start
        row.counters.depthEvaluations += end - start
        row.counters.depthPasses += passes
    }

    private companion object {
        /** A stage: a header and seven fields. */
        const val BYTES = 40L

        /** A cursor that evaluates each row on its own; what a user's own holds is not known. */
        const val CURSOR_BYTES = 24L
    }
}
