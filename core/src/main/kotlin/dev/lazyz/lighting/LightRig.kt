package dev.lazyz.lighting

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.MetallicRoughness
import org.joml.Vector3d

/**
 * A usual arrangement of lights. A matt white surface stays darker than white under all but [FLAT], so that it is
 * visible in front of a white background.
 *
 * ```
 * val lit = LightRig.THREE_POINT.on(scene, scene.camera(640, 480))
 * ```
 *
 * @property environment what materials with [MetallicRoughness] reflect besides the lights; null for the usual one
 */
public enum class LightRig(public val environment: Environment?) {
    /**
     * The lights that scenes without lights have: [Light.studio] and, for materials with [MetallicRoughness],
     * [Environment.USUAL].
     */
    STUDIO(null),

    /**
     * As photographers light a portrait: a warm key light from the upper left, a weaker cool fill light from the right,
     * and a rim light from above and behind that separates the outline from the background.
     */
    THREE_POINT(Environment.studio(0.2f)),

    /** The same light on every surface: base colours as they are, without shades. */
    FLAT(Environment.NONE),

    /** One light at the camera, so that nothing that is visible is in the shade. */
    HEADLIGHT(Environment.studio(0.15f)),

    /** Warm light from high up at the front left of the scene, and blue sky. It stays in place if the camera moves. */
    SUN(Environment.studio(0.2f)),
    ;

    /** Returns the lights for a picture from [camera]; none if they are those of a scene without lights. */
    public fun lights(camera: Camera): List<Light> = when (this) {
        STUDIO -> emptyList()

        THREE_POINT -> listOf(
            Light.Ambient(Rgba(0.03f, 0.03f, 0.035f)),
            Light.Directional(camera.toWorldDirection(0.75, -0.65, -0.75), Rgba(0.62f, 0.58f, 0.52f)),
            Light.Directional(camera.toWorldDirection(-0.95, -0.10, -0.60), Rgba(0.14f, 0.16f, 0.20f)),
            Light.Directional(camera.toWorldDirection(-0.35, -0.80, 0.75), Rgba(0.55f, 0.56f, 0.60f)),
        )

        FLAT -> listOf(Light.Ambient(Rgba.WHITE))

        HEADLIGHT -> listOf(
            Light.Ambient(Rgba(0.05f, 0.05f, 0.05f)),
            Light.Directional(camera.toWorldDirection(0.0, 0.0, -1.0), Rgba(0.72f, 0.72f, 0.72f)),
        )

        SUN -> listOf(
            Light.Ambient(Rgba(0.10f, 0.12f, 0.16f)),
            Light.Directional(Vector3d(0.45, -0.80, -0.55), Rgba(0.68f, 0.64f, 0.54f)),
        )
    }

    /** Returns [scene] with these lights and this [environment] instead of its own, for a picture from [camera]. */
    public fun on(scene: Scene, camera: Camera): Scene =
        scene.withLights(lights(camera)).withEnvironment(environment)
}
