package dev.lazyz.cli.input

import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.Camera
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.Viewpoint
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * The options that place a camera; null means that of the camera that the other options choose. Vectors are in the
 * coordinates of the model.
 *
 * @property height visible height of an orthographic camera, world units
 */
internal class Placement(
    val eye: Vector3dc? = null,
    val target: Vector3dc? = null,
    val up: Vector3dc? = null,
    val height: Double? = null,
    val near: Double? = null,
    val far: Double? = null,
) {
    val isGiven: Boolean get() = listOfNotNull(eye, target, up, height, near, far).isNotEmpty()

    /** Returns these options for a model that was rotated so that the axis [axis] points up. */
    fun withUpAxis(axis: UpAxis): Placement = Placement(
        eye?.let(axis::toWorld), target?.let(axis::toWorld), up?.let(axis::toWorld), height, near, far,
    )
}

/**
 * The camera of [base], placed by [placement].
 *
 * @param fieldOfView vertical field of view in degrees in place of that of [base]; null for its own
 */
internal class PlacedViewpoint(
    private val base: Viewpoint,
    private val placement: Placement,
    private val fieldOfView: Double?,
) : Viewpoint {
    override fun camera(scene: Scene, aspect: Double): Camera {
        val own = base.camera(scene, aspect)
        val eye = placement.eye ?: eye(own)
        val target = placement.target ?: if (placement.eye == null) own.target else center(scene) ?: own.target
        val up = placement.up ?: own.up
        val planes = planes(scene, own, eye, target)
        return when (val projection = own.projection) {
            is Projection.Perspective -> {
                val angle = fieldOfView ?: projection.verticalFieldOfView
                Camera.perspective(eye, target, up, angle, planes.first, planes.second)
            }

            is Projection.Orthographic -> {
                val height = placement.height ?: projection.height
                Camera.orthographic(eye, target, up, height, planes.first, planes.second)
            }

            Projection.Screen -> own
        }
    }

    /** Returns the eye for a new target: a fitted camera keeps direction and distance, others stay where they are. */
    private fun eye(own: Camera): Vector3dc {
        val target = placement.target
        if (target == null || base !is FittedViewpoint) return own.eye
        return Vector3d(
            target.x() + (own.eye.x() - own.target.x()), target.y() + (own.eye.y() - own.target.y()),
            target.z() + (own.eye.z() - own.target.z()),
        )
    }

    private fun center(scene: Scene): Vector3dc? = scene.bounds?.center

    /** Returns the distances of the near and the far plane: those of the options, or around the scene. */
    private fun planes(scene: Scene, own: Camera, eye: Vector3dc, target: Vector3dc): Pair<Double, Double> {
        val isMoved = placement.eye != null || placement.target != null
        val fitted = if (isMoved) around(scene, own.projection, eye, target) else own.near to own.far
        return (placement.near ?: fitted.first) to (placement.far ?: fitted.second)
    }

    private fun around(
        scene: Scene,
        projection: Projection,
        eye: Vector3dc,
        target: Vector3dc,
    ): Pair<Double, Double> {
        // The third row of the view matrix points from the scene to the eye
        val view = Camera.orthographic(eye, target, placement.up ?: UP, 1.0, 0.0, 1.0).viewMatrix()
        val backward = Vector3d(view.m02(), view.m12(), view.m22())
        val first = scene.farthest(backward)
        val last = scene.farthest(Vector3d(-backward.x, -backward.y, -backward.z))
        val front = if (first == null) 0.0 else along(backward, eye) - along(backward, first)
        val back = if (last == null) 1.0 else along(backward, eye) - along(backward, last)

        // Leave room for rounding
        val room = maxOf(0.005 * (back - front), 1e-6 * StrictMath.abs(back), 1e-9)
        if (projection is Projection.Orthographic) return front - room to back + room
        if (back <= 0.0) return 1.0 to 2.0
        return maxOf(front - room, (back + room) / DEPTH_RATIO) to back + room
    }

    private fun along(direction: Vector3dc, point: Vector3dc): Double =
        direction.x() * point.x() + direction.y() * point.y() + direction.z() * point.z()

    private companion object {
        /** Greatest ratio of far and near plane, for an eye that is within the scene. */
        const val DEPTH_RATIO = 8192.0

        val UP: Vector3dc = Vector3d(0.0, 1.0, 0.0)
    }
}
