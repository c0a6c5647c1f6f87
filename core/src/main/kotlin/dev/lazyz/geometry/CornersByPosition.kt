package dev.lazyz.geometry

/**
 * The corners of a mesh's triangles, three a triangle, by where they are: positions are numbered, and each has its
 * corners in the order of the triangles. Immutable.
 */
internal class CornersByPosition(positions: FloatArray, triangles: IntArray) {
    /** By vertex: number of its position. */
    val positionOf: IntArray = positionNumbers(positions)

    /** By position: where in [corners] its corners begin; the next one's are behind. */
    val starts: IntArray

    /** The corners, position by position. */
    val corners: IntArray

    init {
        // Counted two places up, the sums are each position's start one place up, which then moves to its end
        starts = IntArray((positionOf.maxOrNull() ?: -1) + 3)
        for (vertex in triangles) starts[positionOf[vertex] + 2]++
        for (i in 2 until starts.size) starts[i] += starts[i - 1]
        corners = IntArray(triangles.size)
        for ((corner, vertex) in triangles.withIndex()) corners[starts[positionOf[vertex] + 1]++] = corner
    }

    /** How many positions there are. */
    val count: Int get() = starts.size - 2

    /** -0 is where 0 is, and NaN where NaN is; nothing is at one position for being near. */
    private fun positionNumbers(p: FloatArray): IntArray {
        val count = p.size / 3
        val distinct = DistinctTriples(count)
        return IntArray(count) {
            distinct.add((p[3 * it] + 0f).toBits(), (p[3 * it + 1] + 0f).toBits(), (p[3 * it + 2] + 0f).toBits())
        }
    }
}
