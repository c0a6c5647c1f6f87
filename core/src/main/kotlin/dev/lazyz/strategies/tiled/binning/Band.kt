package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.setup.PixelShadedPrimitive
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.tiled.raster.TileGrid
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/**
 * A row of tiles: the bins with the primitives of each tile, and memory for the results.
 *
 * Filled by the calling thread and read by all threads, each of which writes the samples of its own tile; then reused
 * for a later band. A *member* is a primitive of the band, numbered in submission order within the band.
 *
 * @param side how many samples wide and high a pixel of the result is
 */
internal class Band(frame: Frame, private val grid: TileGrid, private val pool: ArrayPool, private val side: Int) {
    private val order = VisibilityOrder(frame.raster.depthTest)
    private val region = frame.region
    private val content = frame.content

    /** First row of samples. */
    var rowStart: Int = 0
        private set

    /** The row after the last. */
    var rowEnd: Int = 0
        private set

    /** Number of the band. */
    var number: Int = 0
        private set

    /** The triangles of batches that reach the band's tiles, or null if there are no batches. */
    var bins: TriangleBins? = null
        private set

    private var count = 0
    private var singles = IntArray(0)
    private var nearest = LongArray(0)
    private var spans = arrayOfNulls<BandSpans>(0)

    /** First and last tile of each member. */
    private var firstColumns = IntArray(0)
    private var lastColumns = IntArray(0)

    /** The bins: the members of tile c are `entries` from `ends[c - 1]` until `ends[c]`, and its part of [wide]. */
    private val ends = IntArray(grid.columns + 1)
    private var entries = IntArray(0)
    private var wide = IntArray(0)
    private var wideCount = 0

    /** Columns of the result. */
    private val width = region.width / side

    /** Number of rows of the result. */
    val rows: Int get() = (rowEnd - rowStart) / side

    /** The visible result, row by row, from the region's first column. */
    val argb: Array<IntArray> = Array(grid.tileHeight / side) { pool.ints(width) }
    val depth: Array<IntArray> = Array(grid.tileHeight / side) { pool.ints(width) }
    val primitive: Array<IntArray> = Array(grid.tileHeight / side) { pool.ints(width) }

    private val remaining = AtomicInteger()

    /** Bytes of the spans that members share, in this band, and the greatest such number so far. */
    private val spanBytes = AtomicLong()
    private var peakSpanBytes = 0L

    /** Whether all tiles have been rendered. */
    val isComplete: Boolean get() = remaining.get() == 0

    /** Peak number of bytes held. */
    val bytes: Long
        get() = 3L * Int.SIZE_BYTES * argb.size * width +
            singles.bytes + firstColumns.bytes + lastColumns.bytes + ends.bytes + entries.bytes + wide.bytes +
            nearest.bytes + spans.bytes + maxOf(peakSpanBytes, spanBytes.get())

    /** The number of a member among the frame's single primitives. */
    fun single(member: Int): Int = singles[member]

    /** A lower bound of the keys of a member. */
    fun nearest(member: Int): Long = nearest[member]

    /** The rows of a member that covers more than one tile and is not a triangle; null for others. */
    fun spans(member: Int): BandSpans? = spans[member]

    /** Fills the bins of band number [band] with the primitives of [arrivals]; [bins] are those of batches. */
    fun fill(band: Int, arrivals: ActivePrimitives, bins: TriangleBins?) {
        number = band
        this.bins = bins
        rowStart = grid.rowStart(band)
        rowEnd = grid.rowEnd(band)
        remaining.set(grid.columns)
        peakSpanBytes = maxOf(peakSpanBytes, spanBytes.getAndSet(0))
        enter(arrivals)

        // Count the members of each tile, except members of many tiles
        ends.fill(0)
        wideCount = 0
        for (member in 0 until count) {
            if (isWide(member)) wideCount++ else tiles(member) { ends[it + 1]++ }
        }

        // Compute prefix sums: the start of each tile's members
        for (column in 0 until grid.columns) ends[column + 1] += ends[column]
        val size = ends[grid.columns]
        if (entries.size < size) entries = IntArray(size + size / 4)
        if (wide.size < wideCount) wide = IntArray(wideCount + wideCount / 4)

        // Enter the members; each start advances to the tile's end
        wideCount = 0
        for (member in 0 until count) {
            if (isWide(member)) wide[wideCount++] = member else tiles(member) { entries[ends[it]++] = member }
        }
    }

    private fun enter(arrivals: ActivePrimitives) {
        count = arrivals.count
        if (singles.size < count) reserve(count + count / 4)
        for (member in 0 until count) {
            endIfInterrupted()
            val single = arrivals.present[member]
            val primitive = content.singles[single]
            val first = grid.columnOf(maxOf(primitive.columnStart, region.columnStart))
            val last = grid.columnOf(minOf(primitive.columnEnd, region.columnEnd) - 1)
            singles[member] = single
            nearest[member] = order.nearestKey(primitive, content.index(single))
            firstColumns[member] = first
            lastColumns[member] = last
            spans[member] = if (first == last || primitive.opaqueTriangle() != null) {
                null
            } else {
                BandSpans(primitive, maxOf(primitive.rowStart, rowStart), minOf(primitive.rowEnd, rowEnd), spanBytes)
            }
        }
        spans.fill(null, count)
    }

    private fun reserve(size: Int) {
        singles = IntArray(size)
        nearest = LongArray(size)
        firstColumns = IntArray(size)
        lastColumns = IntArray(size)
        spans = arrayOfNulls(size)
    }

    private fun isWide(member: Int): Boolean = lastColumns[member] - firstColumns[member] >= WIDE

    private inline fun tiles(member: Int, action: (column: Int) -> Unit) {
        for (column in firstColumns[member]..lastColumns[member]) action(column)
    }

    /** Whether the tile [column] has nothing to draw. */
    fun isEmpty(column: Int): Boolean {
        forEachMember(column) { return false }
        val bins = bins ?: return true
        return bins.triangleCount(number, column) == 0 && bins.fragmentCount(number, column) == 0
    }

    /** Whether the tile [column] has more fragments of small triangles than other triangles. */
    fun isFine(column: Int): Boolean {
        val bins = bins ?: return false
        return bins.fragmentCount(number, column) > bins.triangleCount(number, column)
    }

    /** Calls [action] for each member that may cover samples of the tile [column], in submission order. */
    inline fun forEachMember(column: Int, action: (member: Int) -> Unit) {
        var entry = if (column == 0) 0 else ends[column - 1]
        val entryEnd = ends[column]
        var wideEntry = 0
        while (true) {
            // Merge two ascending lists: the member submitted first is next
            val narrow = if (entry < entryEnd) entries[entry] else NONE
            val broad = if (wideEntry < wideCount) wide[wideEntry] else NONE
            if (narrow == NONE && broad == NONE) return
            if (narrow < broad) {
                entry++
                action(narrow)
            } else {
                wideEntry++
                if (column in firstColumns[broad]..lastColumns[broad]) action(broad)
            }
        }
    }

    /** Records that one more tile has been rendered; returns whether it was the last. */
    fun finishTile(): Boolean = remaining.decrementAndGet() == 0

    /** Passes the rows to [sink], and passes [checkpoint] before each row. */
    fun sendTo(sink: RowSink, checkpoint: Checkpoint) {
        for (row in 0 until rows) {
            checkpoint.pass()
            sink.row(rowStart / side + row, argb[row], depth[row], primitive[row])
        }
    }

    /** Returns the rows' memory to the pool; must be called last. */
    fun release() {
        for (rows in listOf(argb, depth, primitive)) rows.forEach(pool::release)
    }

    companion object {
        /** Greater than all members. */
        private const val NONE = Int.MAX_VALUE

        /**
         * Members that reach at least this many tiles beyond their first are not entered tile by tile. Bins thus take
         * at most this many entries a member, even with small tiles.
         */
        private const val WIDE = 8
    }
}

/** Returns the triangle that this is, if it is drawn in blocks, like those of batches. */
internal fun Primitive.opaqueTriangle(): PlanarPrimitive? {
    val planar = (if (this is PixelShadedPrimitive) whole else this) as? PlanarPrimitive
    return planar?.takeIf { it.isTriangle && !it.isTranslucent }
}

/**
 * The spans of a primitive in one band, for the tiles that share it. The first thread that needs them scan-converts the
 * primitive, once.
 *
 * Without sharing, the polygon's edges or the mask's texels would be processed again for each tile that the rows cross.
 * Thread safe.
 *
 * @param rowStart first row of the primitive in the band
 * @param rowEnd the row after the last
 * @param bytes counter of the bytes held
 */
internal class BandSpans(
    private val primitive: Primitive,
    private val rowStart: Int,
    private val rowEnd: Int,
    private val bytes: AtomicLong,
) {
    /** The rows, once they are known. */
    @Volatile
    private var rows: Rows? = null

    /**
     * The spans of each row: [bounds] holds the first column of each span and the column after its last, row by row;
     * [ends] holds the position in [bounds] where each row ends.
     *
     * @property first the row with the number 0
     */
    class Rows(val first: Int, private val ends: IntArray, private val bounds: IntArray) {
        /** Number of rows. */
        val count: Int get() = ends.size

        /** Position where row number [row] starts. */
        private fun begin(row: Int): Int = if (row == 0) 0 else ends[row - 1]

        /** Position where row number [row] ends. */
        fun end(row: Int): Int = ends[row]

        /** First column of the span at position [at]. */
        fun start(at: Int): Int = bounds[at]

        /** Column after the last of the span at position [at]. */
        fun until(at: Int): Int = bounds[at + 1]

        /**
         * Returns the position of the first span of row number [row] that ends after column [x], or [end] if none does.
         */
        fun firstBehind(row: Int, x: Int): Int {
            var low = begin(row) / 2
            var high = end(row) / 2
            while (low < high) {
                val middle = (low + high) ushr 1
                if (bounds[2 * middle + 1] > x) high = middle else low = middle + 1
            }
            return 2 * low
        }
    }

    /**
     * Returns the rows. The first call counts the fragments of all tiles in [counters]. [scratch] must be limited to
     * the columns of the region; [checkpoint] is called before each row.
     */
    fun rows(scratch: Spans, counters: Counters.Builder, checkpoint: Checkpoint): Rows =
        rows ?: synchronized(this) { rows ?: scan(scratch, counters, checkpoint).also { rows = it } }

    private fun scan(scratch: Spans, counters: Counters.Builder, checkpoint: Checkpoint): Rows {
        val cursor = primitive.cursor(rowStart)
        val ends = IntArray(rowEnd - rowStart)
        var bounds = IntArray(2 * ends.size)
        var used = 0
        for (row in ends.indices) {
            checkpoint.pass()
            cursor.next(scratch)
            if (used + 2 * scratch.count > bounds.size) bounds = bounds.copyOf(2 * (used + 2 * scratch.count))
            for (i in 0 until scratch.count) {
                bounds[used++] = scratch.start(i)
                bounds[used++] = scratch.end(i)
                counters.fragments += scratch.end(i) - scratch.start(i)
            }
            ends[row] = used
        }
        bytes.addAndGet(HeapLayout.BAND_SPANS + ends.bytes + bounds.bytes)
        return Rows(rowStart, ends, bounds)
    }
}
