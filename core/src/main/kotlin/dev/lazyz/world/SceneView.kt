package dev.lazyz.world

import dev.lazyz.FrameView
import org.joml.Vector3dc

/**
 * The view of a scene's frame.
 *
 * @param starts submission index of the first primitive of each surface
 */
internal class SceneView(
    private val camera: Camera,
    private val origin: Vector3dc,
    private val starts: IntArray,
    override val objectNames: List<String>,
) : FrameView {
    override val near: Double get() = camera.near
    override val far: Double get() = camera.far
    override val originX: Double get() = origin.x()
    override val originY: Double get() = origin.y()
    override val originZ: Double get() = origin.z()

    override fun distance(unit: Double): Double = camera.distanceAt(unit)

    override fun distance(x: Float, y: Float, z: Float): Double {
        val dx = camera.eye.x() - originX - x
        val dy = camera.eye.y() - originY - y
        val dz = camera.eye.z() - originZ - z
        return camera.backward.x * dx + camera.backward.y * dy + camera.backward.z * dz
    }

    override fun objectOf(index: Int): Int {
        // The last surface that does not begin later: surfaces without primitives begin where the next one does
        var low = 0
        var high = starts.size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (starts[middle] <= index) low = middle + 1 else high = middle
        }
        return low - 1
    }
}
