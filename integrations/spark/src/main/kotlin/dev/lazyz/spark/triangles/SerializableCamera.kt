package dev.lazyz.spark.triangles

import dev.lazyz.world.Camera
import dev.lazyz.world.Projection
import java.io.Serializable
import org.joml.Vector3d
import org.joml.Vector3dc

/** The values of a camera, on their way to an executor. */
internal class SerializableCamera(camera: Camera) : Serializable {
    private val eye = values(camera.eye)
    private val target = values(camera.target)
    private val up = values(camera.up)
    private val near = camera.near
    private val far = camera.far
    private val fieldOfView = (camera.projection as? Projection.Perspective)?.verticalFieldOfView
    private val height = (camera.projection as? Projection.Orthographic)?.height

    /** Returns the camera. */
    fun camera(): Camera = when {
        fieldOfView != null -> Camera.perspective(vector(eye), vector(target), vector(up), fieldOfView, near, far)
        height != null -> Camera.orthographic(vector(eye), vector(target), vector(up), height, near, far)
        else -> Camera.screen(near, far)
    }

    private companion object {
        const val serialVersionUID = 1L

        fun values(v: Vector3dc) = doubleArrayOf(v.x(), v.y(), v.z())

        fun vector(v: DoubleArray) = Vector3d(v[0], v[1], v[2])
    }
}
