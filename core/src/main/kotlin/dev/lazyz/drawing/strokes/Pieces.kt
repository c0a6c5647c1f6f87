package dev.lazyz.drawing.strokes

/**
 * Straight pieces of edges on the raster, visible ones or hidden ones. A growing list; not thread safe.
 */
internal class Pieces {
    private var places = DoubleArray(64)
    private var ends = IntArray(32)
    private var features = BooleanArray(16)

    /** Number of pieces. */
    var count: Int = 0
        private set

    /** Column of an [end] (0 or 1) of piece [i], pixels. */
    fun x(i: Int, end: Int): Double = places[4 * i + 2 * end]

    /** Row of an [end] of piece [i], pixels. */
    fun y(i: Int, end: Int): Double = places[4 * i + 2 * end + 1]

    /** The point of the model at an [end] of piece [i]; -1 if the piece ends between two points. */
    fun point(i: Int, end: Int): Int = ends[2 * i + end]

    /** Whether piece [i] is a part of a boundary or a crease, not only of a silhouette. */
    fun isFeature(i: Int): Boolean = features[i]

    fun add(x0: Double, y0: Double, point0: Int, x1: Double, y1: Double, point1: Int, isFeature: Boolean) {
        if (count == features.size) {
            places = places.copyOf(2 * places.size)
            ends = ends.copyOf(2 * ends.size)
            features = features.copyOf(2 * features.size)
        }
        places[4 * count] = x0
        places[4 * count + 1] = y0
        places[4 * count + 2] = x1
        places[4 * count + 3] = y1
        ends[2 * count] = point0
        ends[2 * count + 1] = point1
        features[count] = isFeature
        count++
    }

    /** Adds piece [i] of [other]. */
    fun add(other: Pieces, i: Int): Unit = add(
        other.x(i, 0), other.y(i, 0), other.point(i, 0), other.x(i, 1), other.y(i, 1), other.point(i, 1),
        other.isFeature(i),
    )

    fun addAll(other: Pieces) {
        for (i in 0 until other.count) add(other, i)
    }
}
