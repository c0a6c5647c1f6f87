package dev.lazyz.scenes.gltf

import de.javagl.jgltf.impl.v2.Camera as CameraJson
import dev.lazyz.geometry.Box
import dev.lazyz.world.Camera
import dev.lazyz.world.Viewpoint
import org.joml.Matrix4dc
import org.joml.Vector3d

/**
 * Reads cameras (section 3.10). The aspect ratio in the file is ignored: the camera's height is used, and the raster
 * determines the width.
 *
 * A perspective camera without a far plane gets one behind the whole scene. An invalid camera (without an angle or a
 * direction) is ignored with a warning.
 */
internal class GltfCameras(private val document: GltfDocument) {
    /** Returns the first camera among [nodes], or null. */
    fun first(nodes: List<PlacedNode>): Viewpoint? {
        document.count("cameras besides the first are not used", nodes.count { it.node.camera != null } - 1)
        for (placed in nodes) {
            val index = placed.node.camera ?: continue
            val where = "nodes[${placed.index}].camera"
            val json = document.element(document.json.cameras, index, "cameras", where)
            try {
                return viewpoint(json, placed.toWorld)
            } catch (e: IllegalArgumentException) {
                document.warn("cameras[$index] is passed over: ${e.message}")
            }
        }
        return null
    }

    private fun viewpoint(json: CameraJson, toWorld: Matrix4dc): Viewpoint {
        // The camera looks along its -z axis, with y up
        val eye = Vector3d(toWorld.m30(), toWorld.m31(), toWorld.m32())
        val up = Vector3d(toWorld.m10(), toWorld.m11(), toWorld.m12())
        val target = Vector3d(eye.x - toWorld.m20(), eye.y - toWorld.m21(), eye.z - toWorld.m22())

        json.orthographic?.let {
            val height = 2.0 * StrictMath.abs(number(it.ymag, "ymag"))
            return Camera.orthographic(eye, target, up, height, number(it.znear, "znear"), number(it.zfar, "zfar"))
        }
        val perspective = requireNotNull(json.perspective) { "it is neither perspective nor orthographic" }
        val degrees = number(perspective.yfov, "yfov") * (180.0 / StrictMath.PI)
        val near = number(perspective.znear, "znear")
        val far = perspective.zfar?.toDouble()
        if (far != null) return Camera.perspective(eye, target, up, degrees, near, far)

        // Create the camera once now, so that an invalid one is reported while the file is being read
        Camera.perspective(eye, target, up, degrees, near, 2 * near)
        return Viewpoint { bounds, _ ->
            Camera.perspective(eye, target, up, degrees, near, farthest(eye, bounds, near))
        }
    }

    private fun farthest(eye: Vector3d, bounds: Box?, near: Double): Double {
        if (bounds == null) return 2 * near
        val most = (0 until 8).maxOf { number ->
            val corner = bounds.corner(number)
            val x = corner.x - eye.x
            val y = corner.y - eye.y
            val z = corner.z - eye.z
            StrictMath.sqrt(x * x + y * y + z * z)
        }
        return maxOf(MARGIN * most, 2 * near)
    }

    private fun number(value: Float?, name: String): Double = requireNotNull(value) { "$name is missing" }.toDouble()

    private companion object {
        const val MARGIN = 1.01
    }
}
