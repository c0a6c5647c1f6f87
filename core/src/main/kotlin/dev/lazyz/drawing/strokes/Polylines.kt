package dev.lazyz.drawing.strokes

/**
 * Joins [pieces] to polylines: at a point where exactly two pieces end, they are parts of one polyline. Used once; not
 * thread safe. Cost: linear.
 *
 * @param pointCount number of points of the model
 */
internal class Polylines(private val pieces: Pieces, pointCount: Int) {
    /** By point: twice the number of a piece, plus the end that is there; -1 if there is none. */
    private val first = IntArray(pointCount) { -1 }
    private val second = IntArray(pointCount) { -1 }
    private val isUsed = BooleanArray(pieces.count)

    init {
        for (i in 0 until 2 * pieces.count) {
            val point = pieces.point(i / 2, i % 2)
            if (point < 0) continue
            when {
                first[point] == -1 -> first[point] = i
                second[point] == -1 -> second[point] = i
                else -> second[point] = CROWD
            }
        }
    }

    /** Calls [action] with the columns and rows of the points of each polyline, x and y in turn, pixels. */
    fun forEach(action: (DoubleArray) -> Unit) {
        // Those with two ends come first; the others are closed
        for (i in 0 until 2 * pieces.count) if (!isUsed[i / 2] && partner(i) < 0) action(from(i))
        for (i in 0 until pieces.count) if (!isUsed[i]) action(from(2 * i))
    }

    /** Returns the end of another piece that continues the end [i] of a piece, or -1. */
    private fun partner(i: Int): Int {
        val point = pieces.point(i / 2, i % 2)
        if (point < 0 || second[point] < 0) return -1
        return if (first[point] == i) second[point] else first[point]
    }

    private fun from(start: Int): DoubleArray {
        var places = DoubleArray(16)
        var size = 0
        fun add(x: Double, y: Double) {
            if (size == places.size) places = places.copyOf(2 * size)
            places[size++] = x
            places[size++] = y
        }
        add(pieces.x(start / 2, start % 2), pieces.y(start / 2, start % 2))
        var at = start
        while (at >= 0 && !isUsed[at / 2]) {
            isUsed[at / 2] = true
            val other = at xor 1
            add(pieces.x(other / 2, other % 2), pieces.y(other / 2, other % 2))
            at = partner(other)
        }
        return places.copyOf(size)
    }

    private companion object {
        /** More than two pieces end here. */
        const val CROWD = -2
    }
}
