package dev.lazyz.strategies.warnock

import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Spans
import dev.lazyz.raster.VisibilityOrder

/**
 * What a primitive covers in the current band of rows, written down once so that areas of any size can ask.
 *
 * The primitive's own cursor steps through the rows, each evaluated once. How an area relates to the primitive follows
 * from how many of its samples are covered: none, the primitive is *disjoint* from it; all, it is *surrounding*;
 * some, it is *contained* in the area or *intersecting* it, which makes no difference here. The answer is exact, and
 * takes a few steps for each row of the area, not for each sample.
 *
 * @param rowStart the first row that will be asked for
 */
internal class Footprint(val primitive: Primitive, val index: Int, order: VisibilityOrder, rowStart: Int) {
    /** Bounds of the keys of all the primitive's fragments. */
    val nearestKey: Long = order.nearestKey(primitive, index)
    val farthestKey: Long = order.farthestKey(primitive, index)

    private val cursor = primitive.cursor(rowStart)
    private var nextRow = rowStart

    /** The rows of the band that are written down. */
    private var firstRow = 0
    private var lastRow = 0

    /** The spans of row y, from left to right, start and end in turn, from offsets[y - firstRow] on. */
    private var columns = IntArray(0)
    private var offsets = IntArray(1)

    /** Least rectangle around what is covered in the band, or null if nothing is. */
    var box: Region? = null
        private set

    /** Covered samples in the band. */
    var samples: Int = 0
        private set

    /** Bytes held. The cursor belongs to the primitive; it is estimated by that of a triangle. */
    val bytes: Long get() = OBJECT_BYTES + Int.SIZE_BYTES * (columns.size + offsets.size)

    /** Writes down the rows of [band], which follows the last one. [spans] is room for a row. */
    fun moveTo(band: Region, spans: Spans) {
        val end = minOf(primitive.rowEnd, band.rowEnd)
        firstRow = nextRow
        lastRow = maxOf(nextRow, end)
        if (offsets.size <= lastRow - firstRow) offsets = IntArray(lastRow - firstRow + 1)
        var used = 0
        var left = Int.MAX_VALUE
        var right = 0
        var top = lastRow
        var bottom = firstRow
        samples = 0
        for (y in firstRow until lastRow) {
            cursor.next(spans)
            if (columns.size < used + 2 * spans.count) {
                // Room for as many more rows like this one
                columns = columns.copyOf(used + 2 * spans.count * (lastRow - y))
            }
            for (i in 0 until spans.count) {
                columns[used++] = spans.start(i)
                columns[used++] = spans.end(i)
                samples += spans.end(i) - spans.start(i)
            }
            offsets[y - firstRow + 1] = used
            if (spans.count == 0) continue
            left = minOf(left, spans.start(0))
            right = maxOf(right, spans.end(spans.count - 1))
            top = minOf(top, y)
            bottom = y + 1
        }
        nextRow = lastRow
        box = if (top < bottom) Region(left, top, right, bottom) else null
    }

    /** Returns the position of the first span of row [y], which is written down, that ends behind column [x]. */
    fun firstSpan(y: Int, x: Int): Int {
        // Most rows have one span or two, but halving finds it in any number
        var low = offsets[y - firstRow]
        var high = offsets[y - firstRow + 1]
        while (low < high) {
            val middle = low + (high - low) / 4 * 2
            if (columns[middle + 1] > x) high = middle else low = middle + 2
        }
        return low
    }

    /** The position behind the last span of row [y]. */
    fun endOfRow(y: Int): Int = offsets[y - firstRow + 1]

    /** First column of the span at [position]. */
    fun start(position: Int): Int = columns[position]

    /** Column after the last of the span at [position]. */
    fun end(position: Int): Int = columns[position + 1]

    /** Returns the part of [area] within the [box]. The area must have a covered sample. */
    fun boxIn(area: Region): Region {
        val box = checkNotNull(box)
        return if (area.contains(box)) {
            box
        } else {
            Region(
                maxOf(area.columnStart, box.columnStart),
                maxOf(area.rowStart, box.rowStart),
                minOf(area.columnEnd, box.columnEnd),
                minOf(area.rowEnd, box.rowEnd),
            )
        }
    }

    /** Returns how many samples of [area], which lies in the band, are covered. */
    fun samplesIn(area: Region): Int {
        // The box tells what is far away, and what is contained
        val box = box ?: return 0
        val left = area.columnStart
        val right = area.columnEnd
        if (box.columnStart >= right || box.columnEnd <= left) return 0
        if (area.contains(box)) return samples

        // Otherwise the spans of the area's rows are cut to its columns
        var count = 0
        for (y in maxOf(area.rowStart, box.rowStart) until minOf(area.rowEnd, box.rowEnd)) {
            var position = firstSpan(y, left)
            val end = endOfRow(y)
            while (position < end && columns[position] < right) {
                count += minOf(columns[position + 1], right) - maxOf(columns[position], left)
                position += 2
            }
        }
        return count
    }

    private companion object {
        /** The fields here and in the arrays' headers, the box, and a triangle's cursor with its six arrays. */
        const val OBJECT_BYTES = 420L
    }
}
