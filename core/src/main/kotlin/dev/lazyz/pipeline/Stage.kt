package dev.lazyz.pipeline

import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.raster.bytes
import dev.lazyz.raster.forEachKey
import dev.lazyz.spi.Spans

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
