package dev.lazyz.tiled

import dev.lazyz.DepthTest
import dev.lazyz.setup.FrameContent
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.TriangleForms

/**
 * Draws the batches' triangles of one tile from near to far, so that what is hidden is found to be so before it is drawn.
 * Belongs to one thread; used for tile after tile.
 */
internal class BatchTriangles(
    private val content: FrameContent,
    private val test: DepthTest,
    private val keys: TileKeys,
    private val drawing: TileTriangles,
    private val checkpoint: Checkpoint,
) {
    private val forms = TriangleForms(test)

    /** The triangles' nearest keys, in order of arrival and sorted. */
    private var nearest = LongArray(CAPACITY)
    private var sorted = LongArray(CAPACITY)
    private var count = 0
    private val ends = IntArray(BUCKETS + 1)

    /** Bytes held. */
    val bytes: Long
        get() = Long.SIZE_BYTES * (nearest.size + sorted.size).toLong() + Int.SIZE_BYTES * ends.size

    /** Draws what [bins] has for the tile [column] of band number [band]. */
    fun draw(bins: TriangleBins, band: Int, column: Int) {
        drawing.lower(bins, band, column)
        count = bins.triangleCount(band, column)
        if (count > nearest.size) {
            nearest = LongArray(count + count / 4)
            sorted = LongArray(nearest.size)
        }
        bins.copyTriangles(band, column, nearest)
        sort()
        for (i in 0 until count) {
            checkpoint.pass()
            if (sorted[i] >= keys.farthest()) continue
            val index = test.indexOf(sorted[i])
            val batch = batch(index)
            draw(batch, index - batch.first)
        }
    }

    /** The batch of a triangle, mostly that of the one before. */
    private fun batch(index: Int): TriangleBatch {
        val last = lastBatch
        if (last != null && index >= last.first && index < last.first + last.count) return last
        return content.batch(index).also { lastBatch = it }
    }

    private var lastBatch: TriangleBatch? = null

    private fun draw(batch: TriangleBatch, triangle: Int) {
        val grid = batch.grid
        val a = batch.place(triangle, 0)
        val b = batch.place(triangle, 1)
        val c = batch.place(triangle, 2)
        val ax = grid[a]
        val ay = grid[a + 1]
        val bx = grid[b]
        val by = grid[b + 1]
        val cx = grid[c]
        val cy = grid[c + 1]
        if (!drawing.begin(ax, ay, bx, by, cx, cy)) return
        forms.depth(batch, triangle)
        forms.moveTo(keys.columnStart, keys.rowStart)
        drawing.draw(forms, ax, ay, bx, by, cx, cy)
    }

    /** Sorts roughly from near to far: a counting sort by the upper bits in which the keys differ. */
    private fun sort() {
        var least = Long.MAX_VALUE
        var most = Long.MIN_VALUE
        for (i in 0 until count) {
            least = minOf(least, nearest[i])
            most = maxOf(most, nearest[i])
        }
        val shift = maxOf(0, Long.SIZE_BITS - java.lang.Long.numberOfLeadingZeros(most - least) - BUCKET_BITS)
        ends.fill(0)
        for (i in 0 until count) ends[((nearest[i] - least) ushr shift).toInt() + 1]++
        for (bucket in 0 until BUCKETS) ends[bucket + 1] += ends[bucket]
        for (i in 0 until count) sorted[ends[((nearest[i] - least) ushr shift).toInt()]++] = nearest[i]
    }

    private companion object {
        const val CAPACITY = 64
        const val BUCKET_BITS = 8
        const val BUCKETS = 1 shl BUCKET_BITS
    }
}
