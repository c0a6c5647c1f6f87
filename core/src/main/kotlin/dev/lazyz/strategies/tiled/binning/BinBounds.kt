package dev.lazyz.strategies.tiled.binning

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
    val bytes: Long get() = Int.SIZE_BYTES * ends.size.toLong()

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
