package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.FrameContent
import dev.lazyz.Workers
import dev.lazyz.bytes
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.triangleBatch
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * The triangles of a frame's batches, sorted into the tiles of some bands with two counting sorts, in parallel.
 *
 * A triangle whose bounds have only a few samples is drawn immediately, while its vertices are loaded; its tiles
 * receive its fragments, each a key and a place. For every other triangle, a tile receives a lower bound of the
 * triangle's keys. The bound determines the triangle's index and the order of drawing, and if the triangle turns out to
 * be hidden, no other data of it is read. Triangles that reach many tiles are entered after all others are known, see
 * [WideTriangles].
 *
 * A tile's wide triangles come first, followed by the others in submission order. Fragments are in submission order as
 * well. Neither order depends on the number of threads. Memory, taken from a pool: 8 bytes for each pair of a triangle
 * and a tile, 12 a fragment, and 12 for each of both while bins are made; in addition 24 bytes a wide triangle, and 16
 * bytes a tile and thread. Immutable once made, until [finishBand] returns all memory.
 *
 * @param bandStart first band
 * @param bandEnd the band after the last
 * @param coverage creates the loops over small triangles, for one thread each
 * @param checkpoint that of the calling thread
 */
internal class TriangleBins(
    private val content: FrameContent,
    grid: TileGrid,
    test: DepthTest,
    bandStart: Int,
    bandEnd: Int,
    workers: Workers,
    coverage: () -> SmallTriangleKernel,
    private val pool: ArrayPool,
    checkpoint: Checkpoint,
) {
    private val area = BinArea(grid, bandStart, bandEnd)
    private var bandsLeft = bandEnd - bandStart
    private val total = content.batches.sumOf { it.count }
    private val chunks = minOf(workers.threads, (total - 1) / LEAST_CHUNK + 1)

    /** Bounds of each tile's triangles within [triangles], and of its fragments within [keys] and [places]. */
    private val triangleEnds = BinBounds(1 + chunks, area.tiles)
    private val fragmentEnds = BinBounds(chunks, area.tiles)
    private val triangles: LongArray
    private val keys: LongArray
    private val places: IntArray

    /** Peak number of bytes held, while the bins are made. */
    val bytes: Long

    init {
        val fillers = List(chunks) {
            BinFiller(it, area, grid, test, coverage(), pool, triangleEnds, fragmentEnds)
        }
        workers.forEach(chunks, checkpoint) { number, own ->
            forEach(number) { batch, first, count ->
                own.pass()
                fillers[number].enter(batch, first, count)
            }
        }
        val wide = NearToFar()
        for (filler in fillers) wide.addAll(filler.wide)
        wide.sort()
        val parts = if (wide.count == 0) 0 else minOf(chunks, area.bands)
        val wideParts = List(parts) { WideTriangles(content, area, grid, test, pool, triangleEnds) }
        workers.forEach(parts, checkpoint) { number, own -> wideParts[number].enter(wide, number, parts, own) }
        val found = fillers.sumOf { it.bytes } + wide.bytes + wideParts.sumOf { it.bytes }
        triangles = pool.longs(ArrayPool.roomy(triangleEnds.sumUp()))
        val fragments = ArrayPool.roomy(fragmentEnds.sumUp())
        keys = pool.longs(fragments)
        places = pool.ints(fragments)
        workers.forEach(chunks, checkpoint) { number, _ ->
            if (number < parts) wideParts[number].distribute(triangles)
            fillers[number].distribute(triangles, keys, places)
        }
        bytes = found + triangleEnds.bytes + fragmentEnds.bytes + places.bytes + triangles.bytes + keys.bytes
    }

    /** Records that a band's triangles have been drawn. After the last band, returns all memory to the pool. */
    fun finishBand() {
        if (--bandsLeft > 0) return
        pool.release(triangles)
        pool.release(keys)
        pool.release(places)
    }

    /** Copies the nearest keys of the triangles of a tile. */
    fun copyTriangles(band: Int, column: Int, to: LongArray) {
        val tile = area.tile(band, column)
        System.arraycopy(triangles, triangleEnds.start(tile), to, 0, triangleCount(band, column))
    }

    /** Number of triangles of a tile. */
    fun triangleCount(band: Int, column: Int): Int {
        val tile = area.tile(band, column)
        return triangleEnds.end(tile) - triangleEnds.start(tile)
    }

    /** Lowers a tile's keys [to] to those of its fragments; returns the number of keys that were lowered. */
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

    /** Number of fragments of a tile. */
    fun fragmentCount(band: Int, column: Int): Int {
        val tile = area.tile(band, column)
        return fragmentEnds.end(tile) - fragmentEnds.start(tile)
    }

    /** Calls [action] for all triangles of a chunk, several triangles of one batch at a time. */
    private inline fun forEach(chunk: Int, action: (batch: TriangleBatch, first: Int, count: Int) -> Unit) {
        val from = (total.toLong() * chunk / chunks).toInt()
        val until = (total.toLong() * (chunk + 1) / chunks).toInt()
        var offset = 0
        for (number in content.batches.indices) {
            val batch = content.triangleBatch(number)
            val last = minOf(until - offset, batch.count)
            for (first in maxOf(from - offset, 0) until last step SmallTriangleKernel.COUNT) {
                action(batch, first, minOf(last - first, SmallTriangleKernel.COUNT))
            }
            offset += batch.count
        }
    }

    companion object {
        /** Fewest triangles for which another thread is worthwhile. */
        private const val LEAST_CHUNK = 4096

        /** Most tiles for which bins are made at a time, unless a band has more. */
        private const val MOST_TILES = 1 shl 12

        /** Number of bands for which bins are made at a time; at least one. */
        fun bandsAtOnce(grid: TileGrid): Int = maxOf(1, minOf(MOST_TILES / grid.columns, grid.bands))
    }
}

/**
 * The bounds of bins that are stored one after the other: the counts of a counting sort by tiles that several threads
 * do in parallel, one chunk each.
 *
 * For each chunk and tile, an element is first the number of entries; after [sumUp], the position of the next entry;
 * and finally the position after the last entry.
 */
internal class BinBounds(private val chunks: Int, private val tiles: Int) {
    private val ends = IntArray(chunks * tiles)

    /** Bytes held. */
    val bytes: Long get() = ends.bytes

    fun count(chunk: Int, tile: Int) {
        ends[chunk * tiles + tile]++
    }

    /** Replaces counts with start positions, ordered by tile and within a tile by chunk. Returns the total. */
    fun sumUp(): Int {
        var sum = 0
        for (tile in 0 until tiles) {
            for (chunk in 0 until chunks) {
                val count = ends[chunk * tiles + tile]
                ends[chunk * tiles + tile] = sum
                sum = Math.addExact(sum, count)
            }
        }
        return sum
    }

    fun next(chunk: Int, tile: Int): Int = ends[chunk * tiles + tile]++

    fun start(tile: Int): Int = if (tile == 0) 0 else end(tile - 1)

    fun end(tile: Int): Int = ends[(chunks - 1) * tiles + tile]
}

/**
 * The tiles of a set of bins: those of the bands [bandStart] until [bandEnd]. Immutable.
 *
 * @throws IllegalArgumentException if these tiles have more than 2^32 samples
 */
internal class BinArea(private val grid: TileGrid, private val bandStart: Int, bandEnd: Int) {
    /** The samples of these tiles. */
    @JvmField val columnStart: Int = grid.region.columnStart

    @JvmField val columnEnd: Int = grid.region.columnEnd

    @JvmField val rowStart: Int = grid.rowStart(bandStart)

    @JvmField val rowEnd: Int = grid.rowEnd(bandEnd - 1)
    private val columns = grid.columns

    /** Number of bands. */
    val bands: Int = bandEnd - bandStart

    /** Number of tiles. */
    val tiles: Int = bands * columns

    private val stride = VisibilityBuffer.stride(grid)
    private val placeBits = Int.SIZE_BITS - (stride * grid.tileHeight - 1).countLeadingZeroBits()

    init {
        require(tiles.toLong() shl placeBits <= 1L shl Int.SIZE_BITS) {
            "a row of $columns tiles of ${grid.size} x ${grid.size} samples is too long; use smaller tiles (tileSize)"
        }
    }

    /** Converts an index within these bands to a band number. */
    fun band(number: Int): Int = bandStart + number

    /** The number of a tile. */
    fun tile(band: Int, column: Int): Int = (band - bandStart) * columns + column

    /** The tile of a sample and its place in the tile, in one number of 32 bits: see [tileOf] and [placeOf]. */
    fun locate(x: Int, y: Int): Int =
        tile(grid.bandOf(y), grid.columnOf(x)) shl placeBits or grid.rowInTile(y) * stride + grid.columnInTile(x)

    /** The tile of a sample that is at [location]. */
    fun tileOf(location: Int): Int = location ushr placeBits

    /** The place in its tile of a sample that is at [location]. */
    fun placeOf(location: Int): Int = location and (1 shl placeBits) - 1
}
