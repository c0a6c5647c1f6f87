package dev.lazyz.geometry

/**
 * The corners of a mesh's triangles (three for each) grouped by position. Positions are numbered, and the corners of
 * each position are in the order of the triangles. Immutable.
 */
internal class CornersByPosition(positions: FloatArray, triangles: IntArray) {
    /** By vertex: the number of its position. */
    val positionOf: IntArray = positionNumbers(positions)

    /** By position: the index in [corners] of its first corner. The corners of position i end at `starts[i + 1]`. */
    val starts: IntArray

    /** The corners, grouped by position. */
    val corners: IntArray

    init {
        // Counts are stored two places up, so their running sums are the starts of the positions, one place up. The
        // loop below then advances each of them to the end of its position, which is the start of the next
        starts = IntArray((positionOf.maxOrNull() ?: -1) + 3)
        for (vertex in triangles) starts[positionOf[vertex] + 2]++
        for (i in 2 until starts.size) starts[i] += starts[i - 1]
        corners = IntArray(triangles.size)
        for ((corner, vertex) in triangles.withIndex()) corners[starts[positionOf[vertex] + 1]++] = corner
    }

    /** Number of positions. */
    val count: Int get() = starts.size - 2

    private fun positionNumbers(p: FloatArray): IntArray {
        val count = p.size / 3
        val distinct = DistinctTriples(count)
        return IntArray(count) {
            distinct.addPoint(p[3 * it], p[3 * it + 1], p[3 * it + 2])
        }
    }
}
