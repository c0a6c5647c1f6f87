package dev.lazyz.drawing

import dev.lazyz.Raster
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import org.joml.Vector3d

/**
 * Space as [camera] shows it on [raster]: four numbers for each point, in which straight lines are straight.
 *
 * A point at column px and row py of the raster, in pixels, is (px w, py w, w, h). What the camera sees along one ray
 * has the same px and py, and the greater of two h / w is nearer. Under perspective, w is the distance along the line
 * of sight and h is 1; otherwise w is 1 and h is the negative distance. Immutable and thread safe.
 */
internal class ViewSpace(val raster: Raster, private val camera: Camera) {
    /** Whether w differs between points. */
    val isPerspective: Boolean = camera.projection is Projection.Perspective
    private val isScreen = camera.projection == Projection.Screen
    private val scale = 1.0 / camera.halfHeight()
    private val aspect = raster.width.toDouble() / raster.height
    private val right: Vector3d = camera.right
    private val upward: Vector3d = camera.upward
    private val backward: Vector3d = camera.backward

    /** Distance of the near plane along the line of sight. */
    val near: Double get() = camera.near

    /** Distance of the far plane. */
    val far: Double get() = camera.far

    /** Writes the point ([x], [y], [z]), in the camera's world space, to [out] at index [at] and the next three. */
    fun place(x: Double, y: Double, z: Double, out: DoubleArray, at: Int) {
        val dx = x - camera.eye.x()
        val dy = y - camera.eye.y()
        val dz = z - camera.eye.z()
        if (isScreen) {
            out[at] = dx
            out[at + 1] = dy
            out[at + 2] = 1.0
            out[at + 3] = -dz
            return
        }
        val towardRight = right.x * dx + right.y * dy + right.z * dz
        val towardTop = upward.x * dx + upward.y * dy + upward.z * dz
        val toward = backward.x * dx + backward.y * dy + backward.z * dz
        val w = if (isPerspective) -toward else 1.0
        out[at] = (w + towardRight * scale / aspect) * 0.5 * raster.width
        out[at + 1] = (w - towardTop * scale) * 0.5 * raster.height
        out[at + 2] = w
        out[at + 3] = if (isPerspective) 1.0 else toward
    }

    /** Returns the distance of a point with these [w] and [h] along the line of sight. */
    fun distance(w: Double, h: Double): Double = if (isPerspective) w else -h

    /**
     * Returns a number that is not negative if a point with these [w] and [h] is at or beyond the near plane. It is
     * linear, and for the points of a scene it is their distance from that plane.
     */
    fun beyondNear(w: Double, h: Double): Double = if (isPerspective) w - near * h else -h - near * w
}
