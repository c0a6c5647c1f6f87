package dev.lazyz.scenes.scenefile

import dev.lazyz.Rgba
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.Viewpoint
import org.joml.Vector3d
import org.joml.Vector3dc

/** Reads the cameras of a scene file. */
internal class CameraReader(private val up: UpAxis) {
    fun viewpoint(node: JsonNode): Viewpoint {
        val kinds = arrayOf("perspective", "orthographic", "screen", "fit")
        val (kind, value) = node.members(*kinds).one(*kinds)
        return when (kind) {
            "perspective" -> camera(value, "fieldOfView", Camera.Companion::perspective)
            "orthographic" -> camera(value, "height", Camera.Companion::orthographic)
            "screen" -> screen(value)
            else -> fit(value)
        }
    }

    /** Reads a camera that [make] makes of where it is, and of the number called [scale]. */
    private fun camera(
        node: JsonNode,
        scale: String,
        make: (Vector3dc, Vector3dc, Vector3dc, Double, Double, Double) -> Camera,
    ): Camera {
        val members = node.members("eye", "target", "up", scale, "near", "far")
        return node.checked {
            make(
                vector(members.required("eye")),
                vector(members.required("target")),
                members["up"]?.let { vector(it) } ?: Vector3d(0.0, 1.0, 0.0),
                members.required(scale).double(),
                members.required("near").double(),
                members.required("far").double(),
            )
        }
    }

    private fun screen(node: JsonNode): Camera {
        if (up != UpAxis.Y) node.fail("cannot be combined with \"up\": its y points down", "remove \"up\"")
        val members = node.members("near", "far")
        return node.checked { Camera.screen(members["near"]?.double() ?: 0.0, members["far"]?.double() ?: 1.0) }
    }

    private fun fit(node: JsonNode): Viewpoint {
        val members = node.members("azimuth", "elevation", "zoom", "projection", "margin", "fieldOfView")
        return node.checked {
            Camera.fit(
                members["azimuth"]?.double() ?: DEFAULT_AZIMUTH,
                members["elevation"]?.double() ?: DEFAULT_ELEVATION,
                members["zoom"]?.double() ?: 1.0,
                members["projection"]?.choice(SceneFileNames.projections) ?: Fit.PERSPECTIVE,
                members["margin"]?.double() ?: Camera.DEFAULT_MARGIN,
                members["fieldOfView"]?.double() ?: Camera.DEFAULT_FIELD_OF_VIEW,
            )
        }
    }

    private fun vector(node: JsonNode): Vector3d = up.toWorld(Vector3d(node.doubles(3)))

    private companion object {
        const val DEFAULT_AZIMUTH = 30.0
        const val DEFAULT_ELEVATION = 20.0
    }
}

/** Reads a colour: text in sRGB, or three or four numbers in linear light. */
internal object ColorReader {
    fun read(node: JsonNode): Rgba {
        if (node.isText) return node.checked { Rgba.parse(node.text()) }
        if (!node.isList) node.fail("must be a colour", "write \"#rrggbb\" or [red, green, blue]")
        val parts = node.floats()
        if (parts.size !in 3..4) node.fail("needs 3 or 4 numbers, not ${parts.size}")
        return Rgba(parts[0], parts[1], parts[2], if (parts.size == 4) parts[3] else 1f)
    }
}
