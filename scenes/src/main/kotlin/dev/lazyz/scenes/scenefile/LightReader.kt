package dev.lazyz.scenes.scenefile

import dev.lazyz.Rgba
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.json.JsonMembers
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.world.Environment
import dev.lazyz.world.Light
import dev.lazyz.world.Light.Falloff
import dev.lazyz.world.ToneMapping
import org.joml.Vector3d

/** Reads the lights, the environment and the tone mapping of a scene file. */
internal class LightReader(private val up: UpAxis) {
    /** Returns the rig that [node] names, or null if it lists lights. */
    fun rig(node: JsonNode): LightRig? = if (node.isText) node.choice(SceneFileNames.lightRigs) else null

    fun light(node: JsonNode): Light {
        val kinds = arrayOf("ambient", "directional", "point", "spot")
        val (kind, value) = node.members(*kinds).one(*kinds)
        return when (kind) {
            "ambient" -> Light.Ambient(color(value.members("color")))
            "directional" -> {
                val members = value.members("direction", "color")
                value.checked { Light.Directional(vector(members.required("direction")), color(members)) }
            }
            "point" -> {
                val members = value.members("position", "color", "falloff", "range")
                value.checked {
                    Light.Point(vector(members.required("position")), color(members), falloff(value, members))
                }
            }
            else -> spot(value)
        }
    }

    private fun spot(node: JsonNode): Light {
        val members = node.members("position", "direction", "color", "innerAngle", "outerAngle", "falloff", "range")
        return node.checked {
            Light.Spot(
                vector(members.required("position")),
                vector(members.required("direction")),
                color(members),
                members["innerAngle"]?.double() ?: 0.0,
                members["outerAngle"]?.double() ?: DEFAULT_ANGLE,
                falloff(node, members),
            )
        }
    }

    private fun falloff(node: JsonNode, members: JsonMembers): Falloff {
        val range = members["range"]?.double()
        if (members["falloff"]?.choice(SceneFileNames.falloffs) == true) {
            return Falloff.inverseSquare(range ?: Double.POSITIVE_INFINITY)
        }
        if (range != null) node.fail("\"range\" is for lights with a falloff", "add \"falloff\": \"inverse-square\"")
        return Falloff.NONE
    }

    fun environment(node: JsonNode): Environment {
        val members = node.members("studio")
        return node.checked { Environment.studio(members.required("studio").float()) }
    }

    fun intensity(node: JsonNode): Float {
        val factor = node.float()
        if (!(factor >= 0f && factor.isFinite())) node.fail("must be 0 or more, and finite: $factor")
        return factor
    }

    fun toneMapping(node: JsonNode): ToneMapping {
        val members = node.members("curve", "exposure")
        val curve = members["curve"]?.choice(SceneFileNames.toneCurves) ?: ToneMapping.Curve.NONE
        return node.checked { ToneMapping(curve, members["exposure"]?.double() ?: 0.0) }
    }

    private fun color(members: JsonMembers): Rgba = members["color"]?.let(ColorReader::read) ?: Rgba.WHITE

    private fun vector(node: JsonNode): Vector3d = up.toWorld(Vector3d(node.doubles(3)))

    private companion object {
        const val DEFAULT_ANGLE = 45.0
    }
}
