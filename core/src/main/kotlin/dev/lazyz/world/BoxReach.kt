package dev.lazyz.world

import dev.lazyz.Reach
import dev.lazyz.geometry.Box
import dev.lazyz.world.surface.SetUp
import kotlin.math.nextDown
import kotlin.math.nextUp
import org.joml.Vector3d

/** Where what is in a box can be on the raster of [setUp]. */
internal class BoxReach(private val setUp: SetUp) {
    /**
     * Returns a rectangle that contains all samples of triangles in [box], or null if it is not known because the box
     * reaches beyond the near plane, the far plane or the guard band. A null box is empty.
     *
     * The projection of a box is the convex hull of its projected corners. The rectangle is larger by a sample on each
     * side than the corners, because vertices are snapped. Before that, vertices are rounded to 32-bit floats relative
     * to the origin of the set-up, so corners are rounded outwards.
     */
    fun of(box: Box?): Reach? {
        if (box == null) return Reach(0, 0, 0, 0)
        var left = Double.POSITIVE_INFINITY
        var top = Double.POSITIVE_INFINITY
        var right = Double.NEGATIVE_INFINITY
        var bottom = Double.NEGATIVE_INFINITY
        for (number in 0 until 8) {
            val corner = setUp.project(rounded(box.corner(number), number)) ?: return null
            left = minOf(left, corner.x)
            top = minOf(top, corner.y)
            right = maxOf(right, corner.x)
            bottom = maxOf(bottom, corner.y)
        }
        return Reach(
            StrictMath.floor(left).toInt() - 1, StrictMath.floor(top).toInt() - 1,
            StrictMath.ceil(right).toInt() + 1, StrictMath.ceil(bottom).toInt() + 1,
        )
    }

    private fun rounded(corner: Vector3d, number: Int): Vector3d {
        val origin = setUp.origin
        return Vector3d(
            outwards(corner.x, origin.x(), number and 1 != 0),
            outwards(corner.y, origin.y(), number and 2 != 0),
            outwards(corner.z, origin.z(), number and 4 != 0),
        )
    }

    /** Returns a float relative to [origin] that is not between [value] and the middle of the box. */
    private fun outwards(value: Double, origin: Double, isMaximum: Boolean): Double {
        val nearest = (value - origin).toFloat()
        return origin + (if (isMaximum) nearest.nextUp() else nearest.nextDown()).toDouble()
    }
}
