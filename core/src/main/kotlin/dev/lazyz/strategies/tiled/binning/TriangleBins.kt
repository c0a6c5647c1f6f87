package dev.lazyz.strategies.tiled.binning

import dev.lazyz.DepthTest
import dev.lazyz.FrameContent
import dev.lazyz.inParallel
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.setup.planar.triangleBatch
import dev.lazyz.strategies.tiled.raster.TileGrid

/**
 * What the triangles of a frame's batches bring to the tiles of some bands: two counting sorts, in parallel.
 *
 * A triangle whose bounds have a few samples is drawn here and now, while its vertices are at hand: what goes to a tile are
 * its fragments, a key and a place each. Of all others a tile gets a key that none of the triangle's is before: from
 * it follow the triangle's index and the order in which to draw, and of triangles that turn out to be hidden nothing else
 * is ever looked at. Those that reach many tiles are entered when all are known, see [WideTriangles].
 *
 * A tile has the wide triangles first, and then the others in submission order, like its fragments, whatever the number of
 * threads. Memory, lent by a pool: 8 bytes for each pair of a triangle and a tile, 12 a fragment, and 12 for each of both
 * while bins are made; besides 24 bytes a wide triangle, 16 bytes a tile and thread. Immutable once made, until [finishBand]
 * takes it all back.
 *
 * @param bandStart first band
 * @param bandEnd the band after the last
 * @param coverage makes the loops over small triangles, for one thread each
 */
internal class TriangleBins(
    private val content: FrameContent,
    grid: TileGrid,
    test: DepthTest,
    bandStart: Int,
    bandEnd: Int,
    threads: Int,
    coverage: () -> CoverageKernel,
    private val pool: ArrayPool,
) {
    private val area = BinArea(grid, bandStart, bandEnd)
    private var bandsLeft = bandEnd - bandStart
    private val total = content.batches.sumOf { it.count }
    private val chunks = minOf(threads, (total - 1) / LEAST_CHUNK + 1)

    /** Where the triangles of each tile are among [triangles], and its fragments among [keys] and [places]. */
    private val triangleEnds = BinEnds(1 + chunks, area.tiles)
    private val fragmentEnds = BinEnds(chunks, area.tiles)
    private val triangles: LongArray
    private val keys: LongArray
    private val places: IntArray

    /** Bytes held, at most while the bins are made. */
    val bytes: Long

    init {
        val fillers = List(chunks) {
            BinFiller(it, area, grid, test, coverage(), pool, triangleEnds, fragmentEnds)
        }
        inParallel(chunks) { forEach(it, fillers[it]::enter) }
        val wide = NearToFar()
        for (filler in fillers) wide.addAll(filler.wide)
        wide.sort()
        val parts = if (wide.count == 0) 0 else minOf(chunks, area.bands)
        val wideParts = List(parts) { WideTriangles(content, area, grid, test, pool, triangleEnds) }
        inParallel(parts) { wideParts[it].enter(wide, it, parts) }
        val found = fillers.sumOf { it.bytes } + wide.bytes + wideParts.sumOf { it.bytes }
        triangles = pool.longs(ArrayPool.roomy(triangleEnds.sumUp()))
        val fragments = ArrayPool.roomy(fragmentEnds.sumUp())
        keys = pool.longs(fragments)
        places = pool.ints(fragments)
        inParallel(chunks) {
            if (it < parts) wideParts[it].distribute(triangles)
            fillers[it].distribute(triangles, keys, places)
        }
        bytes = found + triangleEnds.bytes + fragmentEnds.bytes + Int.SIZE_BYTES * places.size.toLong() +
            Long.SIZE_BYTES * (triangles.size + keys.size.toLong())
    }

    /** Notes that a band's triangles have been drawn; after the last one's all memory is given back. */
    fun finishBand() {
        if (--bandsLeft > 0) return
        pool.release(triangles)
        pool.release(keys)
        pool.release(places)
    }

    /** Copies the nearest key of each triangle that is to be drawn into a tile. */
    fun copyTriangles(band: Int, column: Int, to: LongArray) {
        val tile = area.tile(band, column)
        System.arraycopy(triangles, triangleEnds.start(tile), to, 0, triangleCount(band, column))
    }

    /** Number of triangles to be drawn into a tile. */
    fun triangleCount(band: Int, column: Int): Int {
        val tile = area.tile(band, column)
        return triangleEnds.end(tile) - triangleEnds.start(tile)
    }

    /** Lowers a tile's keys [to] to those of the fragments that fall into it; returns how many were lowered. */
    fun lower(band: Int, column: Int, to: LongArray): Int {
        val tile = area.tile(band, column)
        var passes = 0
        for (i in fragmentEnds.start(tile) until fragmentEnds.end(tile)) {
            val key = keys[i]
            val place = places[i]
            if (key < to[place]) {
                to[place] = key
                passes++
            }
        }
        return passes
    }

    /** Number of fragments that fall into a tile. */
    fun fragmentCount(band: Int, column: Int): Int {
        val tile = area.tile(band, column)
        return fragmentEnds.end(tile) - fragmentEnds.start(tile)
    }

    /** Calls [action] for all triangles of a chunk, some of one batch at a time. */
    private inline fun forEach(chunk: Int, action: (batch: TriangleBatch, first: Int, count: Int) -> Unit) {
        val from = (total.toLong() * chunk / chunks).toInt()
        val until = (total.toLong() * (chunk + 1) / chunks).toInt()
        var offset = 0
        for (number in content.batches.indices) {
            val batch = content.triangleBatch(number)
            val last = minOf(until - offset, batch.count)
            for (first in maxOf(from - offset, 0) until last step CoverageKernel.COUNT) {
                action(batch, first, minOf(last - first, CoverageKernel.COUNT))
            }
            offset += batch.count
        }
    }

    companion object {
        /** Triangles for which it is not worth to ask another thread. */
        private const val LEAST_CHUNK = 4096

        /** Number of bands that bins are made for at a time; at least one, however many tiles it has. */
        fun bandsAtOnce(grid: TileGrid): Int = maxOf(1, minOf(BinFiller.MOST_TILES / grid.columns, grid.bands))
    }
}
