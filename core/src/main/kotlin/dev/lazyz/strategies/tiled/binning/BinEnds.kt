package dev.lazyz.strategies.tiled.binning

/**
 * Where bins end, which lie one behind the other: the counts of a counting sort by tiles that several threads do, a chunk each.
 *
 * Chunk by chunk, how much each tile gets; then, after [sumUp], where the next goes; and in the end where it ends.
 */
internal class BinEnds(private val chunks: Int, private val tiles: Int) {
    private val ends = IntArray(chunks * tiles)

    /** Bytes held. */
    val bytes: Long get() = Int.SIZE_BYTES * ends.size.toLong()

    fun count(chunk: Int, tile: Int) {
        ends[chunk * tiles + tile]++
    }

    /** Sums up tile by tile, and within a tile chunk by chunk, so that each chunk knows where its share begins. */
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
