package dev.lazyz.scenes.meshes

/** Finds out whether the outline of a polygon in the plane crosses itself. Edges that only touch do not cross. */
internal object Crossings {
    /**
     * Whether the outline with the corners [xy] crosses itself. The time is quadratic in the number of corners.
     *
     * @param step counts steps of work; throws to end it
     */
    fun areIn(xy: DoubleArray, step: (Int) -> Unit): Boolean {
        val corners = xy.size / 2
        for (i in 0 until corners) {
            step(corners - i)
            val a = 2 * i
            val b = 2 * ((i + 1) % corners)
            val left = minOf(xy[a], xy[b])
            val right = maxOf(xy[a], xy[b])
            for (j in i + 2 until corners) {
                val c = 2 * j
                val d = 2 * ((j + 1) % corners)
                if ((xy[c] < left && xy[d] < left) || (xy[c] > right && xy[d] > right)) continue
                if (areApart(xy, a, b, c, d) && areApart(xy, c, d, a, b)) return true
            }
        }
        return false
    }

    /** Whether the corners at [c] and [d] are on different sides of the line from [a] to [b]. */
    private fun areApart(xy: DoubleArray, a: Int, b: Int, c: Int, d: Int): Boolean {
        val first = side(xy, a, b, c)
        val second = side(xy, a, b, d)
        return (first < 0.0 && second > 0.0) || (first > 0.0 && second < 0.0)
    }

    private fun side(xy: DoubleArray, a: Int, b: Int, c: Int): Double =
        (xy[b] - xy[a]) * (xy[c + 1] - xy[a + 1]) - (xy[b + 1] - xy[a + 1]) * (xy[c] - xy[a])
}
