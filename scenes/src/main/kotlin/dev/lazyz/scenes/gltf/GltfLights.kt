package dev.lazyz.scenes.gltf

import dev.lazyz.Rgba
import dev.lazyz.geometry.Box
import dev.lazyz.scenes.gltf.document.ExtensionValues
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.geometry.PlacedNode
import dev.lazyz.world.Scene
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import org.joml.Vector3d

/**
 * Reads the lights of `KHR_lights_punctual`. A light of an unknown type, or with invalid numbers, is ignored with a
 * warning.
 *
 * The file gives illuminance, lux, at any distance for directional lights, and luminous intensity, candela, for the
 * others, with distances in metres. A matt white surface reflects `illuminance / pi`, so this is the colour of a
 * [Light]. Some programs write such numbers for a viewer whose white is 1, and others those of real lights, which are
 * thousands of times larger. Therefore the light is measured as by a photographer: at the centre of the scene, at least
 * half a diagonal of the scene away from each light. If the sum is out of [LEAST]..[MOST], all lights are multiplied by
 * one factor that makes it 1.
 */
internal class GltfLights(private val document: GltfDocument) {
    private val lights: List<*> by lazy {
        document.json.extension(GltfExtensions.LIGHTS)?.get("lights") as? List<*> ?: emptyList<Any>()
    }

    /** Returns the lights of [nodes] for [scene]. */
    fun of(nodes: List<PlacedNode>, scene: Scene): List<Light> {
        val own = nodes.mapNotNull { node ->
            val reference = node.node.extension(GltfExtensions.LIGHTS) ?: return@mapNotNull null
            val where = "nodes[${node.index}].extensions.${GltfExtensions.LIGHTS}.light"
            val index = (reference["light"] as? Number)?.toInt()
            val json = document.element(lights, index, "lights", where) as? Map<*, *>
                ?: document.fail("lights[$index]", "it is not an object")
            try {
                light(json, node)
            } catch (e: IllegalArgumentException) {
                document.warn("lights[$index]", " is passed over: ${e.message}")
                null
            }
        }
        if (own.isEmpty()) return own
        val bounds = scene.bounds
        val sum = own.sumOf { measure(it, bounds) }
        if (sum in LEAST..MOST || !(sum > 0.0)) return own
        return own.map { it.scaled((1.0 / sum).toFloat()) }
    }

    private fun light(json: Map<*, *>, node: PlacedNode): Light {
        val toWorld = node.toWorld
        val color = (json["color"] as? List<*>)?.map { (it as? Number)?.toDouble() ?: 1.0 } ?: listOf(1.0, 1.0, 1.0)
        require(color.size == 3 && color.all { it >= 0.0 && it.isFinite() }) { "its color must be three numbers" }
        val intensity = ExtensionValues.number(json, "intensity", 1.0)
        require(intensity >= 0.0) { "its intensity is negative" }
        val strength = intensity / StrictMath.PI
        val rgba = Rgba(
            (color[0] * strength).toFloat(),
            (color[1] * strength).toFloat(),
            (color[2] * strength).toFloat(),
        )

        // A light shines along its -z axis
        val position = Vector3d(toWorld.m30(), toWorld.m31(), toWorld.m32())
        val direction = Vector3d(-toWorld.m20(), -toWorld.m21(), -toWorld.m22())
        val falloff = Falloff.inverseSquare(ExtensionValues.number(json, "range", Double.POSITIVE_INFINITY))
        return when (val type = json["type"]) {
            "directional" -> Light.Directional(direction, rgba)
            "point" -> Light.Point(position, rgba, falloff)
            "spot" -> {
                val cone = json["spot"] as? Map<*, *> ?: emptyMap<Any, Any>()
                val outer = ExtensionValues.number(cone, "outerConeAngle", StrictMath.PI / 4)
                val inner = ExtensionValues.number(cone, "innerConeAngle", 0.0)
                Light.Spot(position, direction, rgba, degrees(inner), degrees(outer), falloff)
            }
            else -> throw IllegalArgumentException("its type $type is unknown")
        }
    }

    /** Returns the mean of the three components that a light gives to a white surface at the centre of [bounds]. */
    private fun measure(light: Light, bounds: Box?): Double {
        val color = (light.color.red.toDouble() + light.color.green + light.color.blue) / 3
        val position = (light as? Light.Point)?.position ?: (light as? Light.Spot)?.position ?: return color
        if (bounds == null) return 0.0
        val center = Vector3d(bounds.center)
        val x = position.x() - center.x
        val y = position.y() - center.y
        val z = position.z() - center.z
        val corner = bounds.corner(0)
        val cx = corner.x - center.x
        val cy = corner.y - center.y
        val cz = corner.z - center.z
        return color / maxOf(x * x + y * y + z * z, cx * cx + cy * cy + cz * cz, LEAST_SQUARE)
    }

    private fun degrees(radians: Double): Double = minOf(radians * (180.0 / StrictMath.PI), RIGHT_ANGLE)

    private companion object {
        const val LEAST = 0.125
        const val MOST = 8.0
        const val LEAST_SQUARE = 1e-12
        const val RIGHT_ANGLE = 90.0
    }
}
