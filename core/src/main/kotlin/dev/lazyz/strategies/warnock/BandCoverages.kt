package dev.lazyz.strategies.warnock

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Spans
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.byFirstRow
import java.util.Arrays

/**
 * The primitives that may be visible in the current band of rows, from near to far.
 *
 * Primitives are sorted by their first rows, added at the band of their first row, and removed after their last row.
 */
internal class BandCoverages(private val frame: Frame, private val counters: Counters.Builder) {
    private val region = frame.region
    private val order = VisibilityOrder(frame.raster.depthTest)
    private val spans = Spans(region)

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
