package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.NamedCamera
import dev.lazyz.scenes.gltf.document.CameraJson
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.geometry.PlacedNode
import dev.lazyz.scenes.printable
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import org.joml.Matrix4dc
import org.joml.Vector3d

/**
 * Reads the cameras of a scene with the given surfaces (section 3.10). The aspect ratio in the file is ignored: the
 * camera's height is used, and the raster determines the width.
 *
 * A perspective camera without a far plane gets one behind the whole scene. An invalid camera (without an angle or a
 * direction) is ignored with a warning.
 */
internal class GltfCameras(private val document: GltfDocument, private val scene: Scene) {
    /** Returns the cameras among [nodes], in the same order. */
    fun all(nodes: List<PlacedNode>): List<NamedCamera> = nodes.mapNotNull { placed ->
        placed.node.camera?.let { index ->
            val json = document.element(document.json.cameras, index, "cameras", "nodes[${placed.index}].camera")
            try {
                NamedCamera(printable(json.name ?: placed.node.name.orEmpty()), camera(json, placed.toWorld))
            } catch (e: IllegalArgumentException) {
                document.warn("cameras[$index]", " is passed over: ${e.message}")
                null
            }
        }
    }

    private fun camera(json: CameraJson, toWorld: Matrix4dc): Camera {
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
        return Camera.perspective(eye, target, up, degrees, near, perspective.zfar?.toDouble() ?: farthest(eye, near))
    }

    private fun farthest(eye: Vector3d, near: Double): Double {
        val bounds = scene.bounds ?: return 2 * near
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
