package dev.lazyz.strategies.tiled.binning

import dev.lazyz.DepthTest
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.strategies.tiled.raster.SmallCoverage
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.TriangleForms

/**
 * The triangles and fragments that one chunk of a frame's triangles adds to [TriangleBins], in the order in which they
 * were found. Belongs to one thread at a time.
 *
 * @param number number of the chunk
 */
internal class BinFiller(
    private val number: Int,
    private val area: BinArea,
    grid: TileGrid,
    test: DepthTest,
    private val coverage: SmallTriangleKernel,
    pool: ArrayPool,
    private val triangleEnds: BinBounds,
    private val fragmentEnds: BinBounds,
) {
    private val row = WideTriangles.ROW + 1 + number
    private val forms = TriangleForms(test)
    private val tiles = CoarseRaster(area, grid)

    /** Nearest key of each triangle that is neither small nor wide, and a tile that it reaches. */
    private val triangles = KeyedPlaces(pool)

    /** Nearest keys of the wide triangles. */
    val wide: NearToFar = NearToFar()

    /** Key of each fragment, with its tile and its place in the tile, see [BinArea.locate]. */
    private val fragments = KeyedPlaces(pool)

    /** Bytes held. */
    val bytes: Long get() = triangles.bytes + wide.bytes + fragments.bytes

    /** Draws small triangles, and records the others for their tiles, or as [wide]. */
    fun enter(batch: TriangleBatch, first: Int, count: Int) {
        coverage.cover(batch, first, count)
        for (i in 0 until count) {
            val covered = coverage.covered[i]
            if (covered == 0 || !batch.isDrawn(first + i)) continue
            if (covered == SmallTriangleKernel.LARGE) {
                enterLarge(batch, first + i)
            } else {
                draw(batch, first + i, coverage.left[i], coverage.top[i], covered)
            }
        }
    }

    private fun enterLarge(batch: TriangleBatch, triangle: Int) {
        val reached = tiles.begin(batch, triangle)
        if (reached == 0) return
        val nearest = forms.nearest(batch, triangle)
        if (reached >= WideTriangles.TILES) return wide.add(nearest)
        tiles.forEach({ false }) { tile, _ ->
            triangleEnds.count(row, tile)
            triangles.add(nearest, tile)
        }
    }

    /** Draws the samples [covered] of the square that starts at ([left], [top]). */
    private fun draw(batch: TriangleBatch, triangle: Int, left: Int, top: Int, covered: Int) {
        var rest = covered
        if (left < area.columnStart || left + SmallCoverage.SIDE > area.columnEnd || top < area.rowStart ||
            top + SmallCoverage.SIDE > area.rowEnd
        ) {
            rest = rest and withinArea(left, top)
        }
        if (rest == 0) return
        forms.depth(batch, triangle)
        while (rest != 0) {
            val place = Integer.numberOfTrailingZeros(rest)
            val x = left + SmallCoverage.column(place)
            val y = top + SmallCoverage.row(place)
            val location = area.locate(x, y)
            fragmentEnds.count(number, area.tileOf(location))
            fragments.add(forms.keyAt(x, y), location)
            rest = rest and (rest - 1)
        }
    }

    /** Returns the bits of those samples of the square that starts at ([left], [top]) that are in these tiles. */
    private fun withinArea(left: Int, top: Int): Int = SmallCoverage.within(
        (area.columnStart - left).coerceIn(0, SmallCoverage.SIDE),
        (area.columnEnd - left).coerceIn(0, SmallCoverage.SIDE),
        (area.rowStart - top).coerceIn(0, SmallCoverage.SIDE),
        (area.rowEnd - top).coerceIn(0, SmallCoverage.SIDE),
    )

    /** Moves triangles and fragments to their bins; nothing is left here. */
    fun distribute(triangleKeys: LongArray, keys: LongArray, places: IntArray) {
        triangles.forEach { nearest, tile -> triangleKeys[triangleEnds.next(row, tile)] = nearest }
        fragments.forEach { key, location ->
            val to = fragmentEnds.next(number, area.tileOf(location))
            keys[to] = key
            places[to] = area.placeOf(location)
        }
        triangles.release()
        fragments.release()
    }
}

/**
 * A list of pairs of a key and a place, stored in pieces so that it grows without copying. Belongs to one thread at a
 * time.
 */
internal class KeyedPlaces(private val pool: ArrayPool) {
    private val keyPieces = ArrayList<LongArray>()
    private val placePieces = ArrayList<IntArray>()

    /** The last pieces, and the number of their elements in use. */
    private var keys = LongArray(0)
    private var places = IntArray(0)
    private var taken = 0

    /** Bytes held. */
    val bytes: Long get() = keyPieces.size * PIECE * (Long.SIZE_BYTES + Int.SIZE_BYTES).toLong()

    /** Appends a pair. */
    fun add(key: Long, place: Int) {
        if (taken == keys.size) addPieces()
        keys[taken] = key
        places[taken++] = place
    }

    private fun addPieces() {
        keys = pool.longs(PIECE).also { keyPieces += it }
        places = pool.ints(PIECE).also { placePieces += it }
        taken = 0
    }

    /** Calls [action] with each pair, in the order in which they were added. */
    inline fun forEach(action: (key: Long, place: Int) -> Unit) {
        for (piece in keyPieces.indices) {
            val pieceKeys = keyPieces[piece]
            val piecePlaces = placePieces[piece]
            val end = if (pieceKeys === keys) taken else PIECE
            for (i in 0 until end) action(pieceKeys[i], piecePlaces[i])
        }
    }

    /** Returns all memory to the pool; must be called last. */
    fun release() {
        for (piece in keyPieces) pool.release(piece)
        for (piece in placePieces) pool.release(piece)
    }

    companion object {
        /** Pairs in a piece. */
        const val PIECE: Int = 8192
    }
}
