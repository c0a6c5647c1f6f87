package dev.lazyz.scenes.teapot

/** A coordinate axis. */
internal enum class Axis { X, Y, Z }

/**
 * A bicubic Bezier patch: four rows of four control points, row after row, three coordinates each.
 *
 * u runs along a row, v from row to row.
 *
 * @property controlPoints the 48 coordinates; owned by the patch, must not be changed.
 */
internal class BezierPatch(val controlPoints: DoubleArray) {
    init {
        require(controlPoints.size == SIZE) { "a patch has $SIZE coordinates: ${controlPoints.size}" }
    }

    /** Returns the mirror image along [axis], with its rows reversed so that the outside stays outside. */
    fun mirrored(axis: Axis): BezierPatch {
        val image = DoubleArray(SIZE)
        for (point in 0 until SIDE * SIDE) {
            val row = point / SIDE
            val column = point % SIDE
            val from = AXES * (row * SIDE + SIDE - 1 - column)
            for (coordinate in 0 until AXES) {
                val value = controlPoints[from + coordinate]
                // Subtract instead of negating: the mirror image of 0 is 0, not -0
                image[AXES * point + coordinate] = if (coordinate == axis.ordinal) 0.0 - value else value
            }
        }
        return BezierPatch(image)
    }

    override fun toString(): String = "BezierPatch(${controlPoints.joinToString()})"

    companion object {
        /** Control points per row, and rows per patch. */
        const val SIDE: Int = 4

        /** Coordinates per control point. */
        const val AXES: Int = 3

        private const val SIZE = SIDE * SIDE * AXES
    }
}
