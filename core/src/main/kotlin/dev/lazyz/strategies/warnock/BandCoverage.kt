package dev.lazyz.strategies.warnock

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.byFirstRow
import dev.lazyz.spi.Spans
import java.util.Arrays

/**
 * The spans of a primitive in the current band of rows, recorded once for queries by areas of any size.
 *
 * The primitive's own cursor steps through the rows, and each row is evaluated once. The number of covered samples in
 * an area determines how the area relates to the primitive. If no sample is covered, the primitive is *disjoint*. If
 * all are covered, it is *surrounding*. If some are covered, it is *contained* or *intersecting*; these two are treated
 * alike. The result is exact and takes a few steps for each row of the area, not for each sample.
 *
 * @param rowStart the first row of the first band
 */
internal class BandCoverage(val primitive: Primitive, val index: Int, order: VisibilityOrder, rowStart: Int) {
    /** Bounds of the keys of all the primitive's fragments. */
    val nearestKey: Long = order.nearestKey(primitive, index)
    val farthestKey: Long = order.farthestKey(primitive, index)

    private val cursor = primitive.cursor(rowStart)
    private var nextRow = rowStart

    /** The rows of the band that are recorded. */
    private var firstRow = 0
    private var lastRow = 0

    /** The spans of row y start at offsets[y - firstRow], from left to right, each as start and end. */
    private var columns = IntArray(0)
    private var offsets = IntArray(1)

    /** Bounding box of the covered samples in the band, or null if there are none. */
    var box: Region? = null
        private set

    /** Number of covered samples in the band. */
    var samples: Int = 0
        private set

    /** Bytes held. The cursor belongs to the primitive; its size is estimated as that of a triangle's cursor. */
    val bytes: Long get() = HeapLayout.BAND_COVERAGE + columns.bytes + offsets.bytes

    /** Records the rows of [band], which follows the last band. [spans] is scratch space for one row. */
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
                // Allocate room as if all remaining rows were like this one
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

    /** Returns the position of the first span of the recorded row [y] that ends after column [x]. */
    fun firstSpan(y: Int, x: Int): Int {
        // Most rows have one or two spans, but binary search also handles many
        var low = offsets[y - firstRow]
        var high = offsets[y - firstRow + 1]
        while (low < high) {
            val middle = low + (high - low) / 4 * 2
            if (columns[middle + 1] > x) high = middle else low = middle + 2
        }
        return low
    }

    /** The position after the last span of row [y]. */
    fun endOfRow(y: Int): Int = offsets[y - firstRow + 1]

    /** First column of the span at [position]. */
    fun start(position: Int): Int = columns[position]

    /** Column after the last of the span at [position]. */
    fun end(position: Int): Int = columns[position + 1]

    /** Returns the part of [area] within the [box]. The band must have a covered sample. */
    fun boxIn(area: Region): Region = checkNotNull(area.intersect(checkNotNull(box)))

    /** Returns the number of covered samples in [area], which lies in the band. */
    fun samplesIn(area: Region): Int {
        // The box decides whether the primitive is far away or contained
        val part = box?.let { area.intersect(it) } ?: return 0
        if (part === box) return samples

        // Otherwise clip the spans of the area's rows to its columns
        val left = part.columnStart
        val right = part.columnEnd
        var count = 0
        for (y in part.rowStart until part.rowEnd) {
            var position = firstSpan(y, left)
            val end = endOfRow(y)
            while (position < end && columns[position] < right) {
                count += minOf(columns[position + 1], right) - maxOf(columns[position], left)
                position += 2
            }
        }
        return count
    }
}

/**
 * The primitives that may be visible in the current band of rows, from near to far.
 *
 * Primitives are sorted by their first rows, added at the band of their first row, and removed after their last row.
 */
internal class BandCoverages(private val frame: Frame, private val counters: Counters.Builder) {
    private val region = frame.region
    private val order = VisibilityOrder(frame.raster.depthTest)
    private val spans = region.spans()

    /** First row in the upper half, index in the lower half, ascending. */
    private val waiting = frame.byFirstRow(Checkpoint.CALLER)
    private var joined = 0
    private var active = arrayOfNulls<BandCoverage>(INITIAL)

    /** Number of primitives that cover something in the band, or may do so in the next. */
    var count: Int = 0
        private set

    /** Bytes currently held. The list of references is counted twice, because sorting may need as much again. */
    var bytes: Long = 0
        private set

    /** Returns the coverage [number]. Coverages are in ascending order of their nearest possible keys. */
    operator fun get(number: Int): BandCoverage = active[number]!!

    /** Moves to [band], which follows the last band. */
    fun moveTo(band: Region) {
        // Add
        while (joined < waiting.size && (waiting[joined] shr 32).toInt() < band.rowEnd) {
            endIfInterrupted()
            if (count == active.size) active = active.copyOf(2 * count)
            val index = waiting[joined].toInt()
            active[count++] = BandCoverage(frame.primitives[index], index, order, (waiting[joined] shr 32).toInt())
            joined++
        }

        // Remove
        var kept = 0
        for (i in 0 until count) if (get(i).primitive.rowEnd > band.rowStart) active[kept++] = active[i]
        active.fill(null, kept, count)
        count = kept

        // Record what is covered, and sort from near to far
        bytes = waiting.bytes + 2 * active.bytes + spans.bytes
        for (i in 0 until count) {
            endIfInterrupted()
            val coverage = get(i)
            coverage.moveTo(band, spans)
            counters.fragments += coverage.samples
            bytes += coverage.bytes
        }
        Arrays.sort(active, 0, count, NEAREST_FIRST)
    }

    private companion object {
        const val INITIAL = 16

        val NEAREST_FIRST = Comparator<BandCoverage?> { a, b ->
            endIfInterrupted()
            a!!.nearestKey.compareTo(b!!.nearestKey)
        }
    }
}
