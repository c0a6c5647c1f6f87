package dev.lazyz.world.surface

import dev.lazyz.geometry.Vectors
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A search for the point that is farthest along [direction]. Of several, the first in the order of x, then y, then z is
 * found, so the result does not depend on the order of the points.
 */
internal class FarthestPoint(private val direction: Vector3dc) {
    private var most = Double.NEGATIVE_INFINITY

    /** The farthest point so far, or null. */
    var point: Vector3d? = null
        private set

    fun look(candidate: Vector3d) {
        val product = Vectors.dot(direction, candidate)
        val best = point
        if (best == null || product > most || (product == most && isBefore(candidate, best))) {
            most = product
            point = candidate
        }
    }

    companion object {
        fun isBefore(a: Vector3dc, b: Vector3dc): Boolean = when {
            a.x() != b.x() -> a.x() < b.x()
            a.y() != b.y() -> a.y() < b.y()
            else -> a.z() < b.z()
        }
    }
}
