package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Frame
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.reaches
import dev.lazyz.strategies.tiled.raster.TileGrid

/**
 * Determines, band by band from the top, which primitives that are in no batch may cover samples of the current band.
 *
 * Primitives are sorted by their first bands. Those that have started and not yet ended are carried over from band to
 * band, so memory does not grow with the number of bands that a primitive covers. Belongs to one thread.
 */
internal class ActivePrimitives(frame: Frame, private val grid: TileGrid) {
    private val region = frame.region
    private val singles = frame.content.singles

    /** The primitives of the region, sorted by first band, then by index. */
    private val waiting: IntArray
    private var entered = 0

    /** Numbers of the primitives of the current band, ascending; the first [count] are valid. */
    var present: IntArray = IntArray(CAPACITY)
        private set

    /** Number of primitives of the current band. */
    var count: Int = 0
        private set

    private var spare = IntArray(CAPACITY)

    init {
        // Find the primitives that may cover samples of the region
        val all = IntArray(singles.size)
        val firstBand = IntArray(singles.size)
        var found = 0
        for ((index, primitive) in singles.withIndex()) {
            endIfInterrupted()
            if (!primitive.reaches(region)) continue
            firstBand[index] = grid.bandOf(maxOf(primitive.rowStart, region.rowStart))
            all[found++] = index
        }
        waiting = sorted(all.copyOf(found), firstBand)
    }

    /** Peak number of bytes held: while sorting, or later in [waiting], [present] and [spare]. */
    val bytes: Long
        get() = waiting.bytes + maxOf(2L * Int.SIZE_BYTES * singles.size + waiting.bytes, present.bytes + spare.bytes)

    /** Moves to [band]; must be called for each band, in order. */
    fun moveTo(band: Int) {
        // Merge primitives that start here with those present, both in submission order; drop those that have ended
        val rowStart = grid.rowStart(band)
        val rowEnd = grid.rowEnd(band)
        var merged = 0
        var next = 0
        while (true) {
            while (next < count && singles[present[next]].rowEnd <= rowStart) next++
            val old = if (next < count) present[next] else NONE
            val new = if (entered < waiting.size && begins(waiting[entered], rowEnd)) waiting[entered] else NONE
            if (old == NONE && new == NONE) break
            if (merged == spare.size) spare = spare.copyOf(2 * merged)
            spare[merged++] = minOf(old, new)
            if (old < new) next++ else entered++
        }
        val before = present
        present = spare
        spare = before
        count = merged
    }

    private fun begins(index: Int, rowEnd: Int): Boolean = singles[index].rowStart < rowEnd

    /**
     * Stable sort of [indices] by their [keys]: two counting sorts, by the lower bits and by the upper bits. With a
     * single counting sort, the number of counts would grow with the number of bands.
     */
    private fun sorted(indices: IntArray, keys: IntArray): IntArray {
        val other = IntArray(indices.size)
        countingSort(indices, other, keys, 0)
        if (grid.bands <= DIGITS) return other
        countingSort(other, indices, keys, DIGIT_BITS)
        return indices
    }

    private fun countingSort(from: IntArray, to: IntArray, keys: IntArray, shift: Int) {
        val ends = IntArray(DIGITS + 1)
        for (index in from) ends[(keys[index] shr shift and DIGITS - 1) + 1]++
        for (digit in 0 until DIGITS) ends[digit + 1] += ends[digit]
        for (index in from) to[ends[keys[index] shr shift and DIGITS - 1]++] = index
    }

    private companion object {
        const val CAPACITY = 64

        /** Greater than all indices. */
        const val NONE = Int.MAX_VALUE

        /** Half the bits of a band number: there are at most 2^18 bands, as many as rows. */
        const val DIGIT_BITS = 9
        const val DIGITS = 1 shl DIGIT_BITS
    }
}
