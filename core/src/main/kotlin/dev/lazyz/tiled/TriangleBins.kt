package dev.lazyz.tiled

import dev.lazyz.DepthTest
import dev.lazyz.setup.FrameContent
import dev.lazyz.setup.ScreenGrid
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.TriangleForms
import dev.lazyz.setup.inParallel

/**
 * What the triangles of a frame's batches bring to the tiles of some bands: two counting sorts, in parallel.
 *
 * A triangle whose bounds have a few samples is drawn here and now, while its vertices are at hand: what goes to a tile are
 * its fragments, a key and a place each. Of all others a tile gets a key that none of the triangle's is before: from
 * it follow the triangle's index and the order in which to draw, and of triangles that turn out to be hidden nothing else
 * is ever looked at.
 *
 * A tile's fragments and triangles are in submission order, whatever the number of threads. Memory: 8 bytes for each pair
 * of a triangle and a tile, 12 a fragment, as much again or twice as much while they are made; 8 bytes a tile and thread.
 * Immutable once made.
 *
 * @param bandStart first band
 * @param bandEnd the band after the last
 * @param stride places of a row of a tile, see [TileKeys.stride]
 */
internal class TriangleBins(
    private val content: FrameContent,
    private val grid: TileGrid,
    private val test: DepthTest,
    private val stride: Int,
    private val bandStart: Int,
    private val bandEnd: Int,
    threads: Int,
    kernels: () -> Kernels,
) {
    private val leftmost = grid.region.columnStart
    private val rightmost = grid.region.columnEnd
    private val columns = grid.columns
    private val rowStart = grid.rowStart(bandStart)
    private val rowEnd = grid.rowEnd(bandEnd - 1)
    private val tiles = (bandEnd - bandStart) * columns
    private val total = content.batches.sumOf { it.count }
    private val chunks = minOf(threads, (total - 1) / LEAST_CHUNK + 1)

    /** Where the triangles of each tile are among [triangles], and its fragments among [keys] and [places]. */
    private val triangleEnds = BinEnds(chunks, tiles)
    private val fragmentEnds = BinEnds(chunks, tiles)
    private val triangles: LongArray
    private val keys: LongArray
    private val places: IntArray

    /** Bytes held, at most while the bins are made. */
    val bytes: Long

    init {
        val found = arrayOfNulls<Chunk>(chunks)
        inParallel(chunks) { number ->
            found[number] = Chunk(number, kernels().coverage).also { chunk -> forEach(number, chunk::enter) }
        }
        triangles = LongArray(triangleEnds.sumUp())
        keys = LongArray(fragmentEnds.sumUp())
        places = IntArray(keys.size)
        inParallel(chunks) { found[it]!!.distribute() }
        bytes = Int.SIZE_BYTES * (2L * chunks * tiles + places.size) +
            Long.SIZE_BYTES * (triangles.size + keys.size.toLong()) + found.sumOf { it!!.bytes }
    }

    /** Copies the nearest key of each triangle that is to be drawn into a tile, in submission order. */
    fun copyTriangles(band: Int, column: Int, to: LongArray) {
        val tile = tile(band, column)
        System.arraycopy(triangles, triangleEnds.start(tile), to, 0, triangleCount(band, column))
    }

    /** Number of triangles to be drawn into a tile. */
    fun triangleCount(band: Int, column: Int): Int {
        val tile = tile(band, column)
        return triangleEnds.end(tile) - triangleEnds.start(tile)
    }

    /** Lowers a tile's keys [to] to those of the fragments that fall into it; returns how many were lowered. */
    fun lower(band: Int, column: Int, to: LongArray): Int {
        val tile = tile(band, column)
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
        val tile = tile(band, column)
        return fragmentEnds.end(tile) - fragmentEnds.start(tile)
    }

    /** Calls [action] for all triangles of a chunk, some of one batch at a time. */
    private inline fun forEach(chunk: Int, action: (batch: TriangleBatch, first: Int, count: Int) -> Unit) {
        val from = (total.toLong() * chunk / chunks).toInt()
        val until = (total.toLong() * (chunk + 1) / chunks).toInt()
        var offset = 0
        for (batch in content.batches) {
            val last = minOf(until - offset, batch.count)
            for (first in maxOf(from - offset, 0) until last step CoverageKernel.COUNT) {
                action(batch, first, minOf(last - first, CoverageKernel.COUNT))
            }
            offset += batch.count
        }
    }

    /** Calls [action] for each tile that the bounds of a triangle reach, unless one of its edges has the tile outside. */
    private inline fun forEachTile(batch: TriangleBatch, triangle: Int, action: (tile: Int) -> Unit) {
        val a = batch.place(triangle, 0)
        val b = batch.place(triangle, 1)
        val c = batch.place(triangle, 2)
        val ax = batch.grid[a]
        val ay = batch.grid[a + 1]
        val bx = batch.grid[b]
        val by = batch.grid[b + 1]
        val cx = batch.grid[c]
        val cy = batch.grid[c + 1]
        val columnStart = maxOf(ScreenGrid.firstSample(minOf(ax, minOf(bx, cx))), leftmost)
        val columnEnd = minOf(ScreenGrid.firstSample(maxOf(ax, maxOf(bx, cx))), rightmost)
        val first = maxOf(ScreenGrid.firstSample(minOf(ay, minOf(by, cy))), rowStart)
        val end = minOf(ScreenGrid.firstSample(maxOf(ay, maxOf(by, cy))), rowEnd)
        val area = (bx - ax).toLong() * (cy - ay) - (cx - ax).toLong() * (by - ay)
        val sign = if (area < 0) -1L else 1L
        val firstColumn = grid.columnOf(columnStart)
        val lastColumn = grid.columnOf(columnEnd - 1)
        val firstBand = grid.bandOf(first)
        val lastBand = grid.bandOf(end - 1)
        val isMany = lastColumn > firstColumn && lastBand > firstBand
        for (band in firstBand..lastBand) {
            val top = grid.rowStart(band)
            val bottom = grid.rowEnd(band) - 1
            for (column in firstColumn..lastColumn) {
                val left = grid.columnStart(column)
                val right = grid.columnEnd(column) - 1
                val isOutside = isMany && (
                    isOutside(sign, ax, ay, bx, by, left, right, top, bottom) ||
                        isOutside(sign, bx, by, cx, cy, left, right, top, bottom) ||
                        isOutside(sign, cx, cy, ax, ay, left, right, top, bottom)
                    )
                if (!isOutside) action(tile(band, column))
            }
        }
    }

    /** Whether all samples of a rectangle are on the outer side of an edge. */
    private fun isOutside(
        sign: Long,
        fromX: Int,
        fromY: Int,
        toX: Int,
        toY: Int,
        left: Int,
        right: Int,
        top: Int,
        bottom: Int,
    ): Boolean {
        // The sample at which the edge function is greatest
        val runX = sign * (toX - fromX)
        val runY = sign * (toY - fromY)
        val x = (if (runY < 0) right else left) * ScreenGrid.STEPS + ScreenGrid.CENTER
        val y = (if (runX > 0) bottom else top) * ScreenGrid.STEPS + ScreenGrid.CENTER
        return runX * (y - fromY) - runY * (x - fromX) < 0
    }

    /** What one chunk of the triangles brings, in the order in which it was found. Belongs to one thread. */
    private inner class Chunk(private val number: Int, private val coverage: CoverageKernel) {
        private val forms = TriangleForms(test)

        /** Nearest key of each triangle that is not small, and its tile or, negative, the number of its tiles in [several]. */
        private var nearestFound = LongArray(LEAST_CHUNK)
        private var tilesFound = IntArray(LEAST_CHUNK)
        private var triangleCount = 0

        /** The tiles of triangles that have more than one. */
        private var several = IntArray(LEAST_CHUNK)
        private var severalCount = 0

        /** Key of each fragment; its tile and its place there, [TILE_SHIFT] bits apart. */
        private var keysFound = LongArray(maxOf(LEAST_CHUNK, total / chunks / 2))
        private var placesFound = IntArray(keysFound.size)
        private var fragmentCount = 0

        val bytes: Long
            get() = (Long.SIZE_BYTES + Int.SIZE_BYTES) * (nearestFound.size + keysFound.size.toLong()) +
                Int.SIZE_BYTES * several.size

        /** Draws triangles that are small, and counts the others for their tiles. */
        fun enter(batch: TriangleBatch, first: Int, count: Int) {
            coverage.cover(batch, first, count)
            for (i in 0 until count) {
                val covered = coverage.covered[i]
                if (covered == 0 || !batch.isDrawn(first + i)) continue
                if (covered == CoverageKernel.LARGE) {
                    enterLarge(batch, first + i)
                } else {
                    draw(batch, first + i, coverage.left[i], coverage.top[i], covered)
                }
            }
        }

        private fun enterLarge(batch: TriangleBatch, triangle: Int) {
            val snapped = batch.grid
            val a = batch.place(triangle, 0)
            val b = batch.place(triangle, 1)
            val c = batch.place(triangle, 2)
            val left = ScreenGrid.firstSample(minOf(snapped[a], minOf(snapped[b], snapped[c])))
            val right = ScreenGrid.firstSample(maxOf(snapped[a], maxOf(snapped[b], snapped[c])))
            val top = ScreenGrid.firstSample(minOf(snapped[a + 1], minOf(snapped[b + 1], snapped[c + 1])))
            val bottom = ScreenGrid.firstSample(maxOf(snapped[a + 1], maxOf(snapped[b + 1], snapped[c + 1])))
            val columnStart = maxOf(left, leftmost)
            val columnEnd = minOf(right, rightmost)
            val first = maxOf(top, rowStart)
            val end = minOf(bottom, rowEnd)
            if (columnStart >= columnEnd || first >= end) return
            val firstTile = tileAt(columnStart, first)
            if (firstTile == tileAt(columnEnd - 1, end - 1)) {
                triangleEnds.count(number, firstTile)
                keep(forms.nearest(batch, triangle), firstTile)
            } else {
                val before = severalCount
                forEachTile(batch, triangle) {
                    triangleEnds.count(number, it)
                    if (severalCount == several.size) several = several.copyOf(2 * severalCount)
                    several[severalCount++] = it
                }
                if (severalCount > before) keep(forms.nearest(batch, triangle), before - severalCount)
            }
        }

        private fun keep(nearest: Long, tile: Int) {
            if (triangleCount == nearestFound.size) {
                nearestFound = nearestFound.copyOf(2 * triangleCount)
                tilesFound = tilesFound.copyOf(2 * triangleCount)
            }
            nearestFound[triangleCount] = nearest
            tilesFound[triangleCount++] = tile
        }

        /** Draws the samples [covered] of the square from ([left], [top]) on. */
        private fun draw(batch: TriangleBatch, triangle: Int, left: Int, top: Int, covered: Int) {
            var rest = covered
            if (left < leftmost || left + SmallCoverage.SIDE > rightmost || top < rowStart ||
                top + SmallCoverage.SIDE > rowEnd
            ) {
                rest = rest and here(left, top)
            }
            if (rest == 0) return
            forms.depth(batch, triangle)
            if (fragmentCount + MOST_FRAGMENTS > keysFound.size) {
                keysFound = keysFound.copyOf(2 * keysFound.size)
                placesFound = placesFound.copyOf(keysFound.size)
            }
            while (rest != 0) {
                val place = Integer.numberOfTrailingZeros(rest)
                add(left + SmallCoverage.column(place), top + SmallCoverage.row(place))
                rest = rest and (rest - 1)
            }
        }

        /** Returns the bits of the samples that are in these bands, of the square from ([left], [top]) on. */
        private fun here(left: Int, top: Int): Int = SmallCoverage.within(
            (leftmost - left).coerceIn(0, SmallCoverage.SIDE),
            (rightmost - left).coerceIn(0, SmallCoverage.SIDE),
            (rowStart - top).coerceIn(0, SmallCoverage.SIDE),
            (rowEnd - top).coerceIn(0, SmallCoverage.SIDE),
        )

        private fun add(x: Int, y: Int) {
            val tile = tileAt(x, y)
            keysFound[fragmentCount] = forms.keyAt(x, y)
            placesFound[fragmentCount++] = tile shl TILE_SHIFT or grid.rowInTile(y) * stride + grid.columnInTile(x)
            fragmentEnds.count(number, tile)
        }

        /** Puts fragments and triangles where they belong. */
        fun distribute() {
            for (i in 0 until fragmentCount) {
                val to = fragmentEnds.next(number, placesFound[i] ushr TILE_SHIFT)
                keys[to] = keysFound[i]
                places[to] = placesFound[i] and (1 shl TILE_SHIFT) - 1
            }
            var taken = 0
            for (i in 0 until triangleCount) {
                val tile = tilesFound[i]
                if (tile >= 0) {
                    triangles[triangleEnds.next(number, tile)] = nearestFound[i]
                } else {
                    for (k in 0 until -tile) triangles[triangleEnds.next(number, several[taken++])] = nearestFound[i]
                }
            }
        }
    }

    private fun tile(band: Int, column: Int): Int = (band - bandStart) * columns + column

    private fun tileAt(x: Int, y: Int): Int = tile(grid.bandOf(y), grid.columnOf(x))

    companion object {
        private const val MOST_FRAGMENTS = SmallCoverage.SIDE * SmallCoverage.SIDE

        /** Triangles for which it is not worth to ask another thread. */
        private const val LEAST_CHUNK = 4096

        /** Most tiles that bins are made for at a time: 12 bits. */
        private const val MOST_TILES = 1 shl 12

        /** A tile has at most 2^18 places. */
        private const val TILE_SHIFT = 18

        /** Number of bands that bins are made for at a time; at least one, however many tiles it has. */
        fun bandsAtOnce(grid: TileGrid): Int = maxOf(1, minOf(MOST_TILES / grid.columns, grid.bands))
    }
}
