package dev.lazyz.shading.pbr

import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Surroundings

/**
 * An environment as placed around a scene: upright, the studio with its front on the side of the camera. Immutable and
 * thread safe.
 *
 * @param intensity factor of the light
 * @param sine x of the direction in world space of the front, where z points in the space of the [light]
 * @param cosine z of that direction
 */
internal class EnvironmentView private constructor(
    private val light: Surroundings,
    private val intensity: Float,
    private val sine: Float,
    private val cosine: Float,
) {
    /** Stores [Surroundings.radiance] around a direction in world space in [surface]. */
    fun radiance(x: Float, y: Float, z: Float, roughness: Float, surface: FloatArray) {
        val at = PhysicalSurface.RADIANCE
        light.radiance(x(x, z), y, z(x, z), roughness, surface, at)
        for (channel in 0 until 3) surface[at + channel] *= intensity
    }

    /** Stores [Surroundings.irradiance] for a direction in world space in [surface]. */
    fun irradiance(x: Float, y: Float, z: Float, surface: FloatArray) {
        val at = PhysicalSurface.IRRADIANCE
        light.irradiance(x(x, z), y, z(x, z), surface, at)
        for (channel in 0 until 3) surface[at + channel] *= intensity
    }

    /** Returns the x in the space of the environment of a direction in world space. */
    private fun x(x: Float, z: Float): Float = cosine * x - sine * z

    /** Returns the z in the space of the environment of a direction in world space. */
    private fun z(x: Float, z: Float): Float = sine * x + cosine * z

    companion object {
        /** Returns the view of [environment] from [camera]; null if there is no environment. */
        fun of(environment: Environment, camera: Camera): EnvironmentView? {
            if (environment.intensity == 0f) return null
            val map = environment.map
            if (map != null) {
                val angle = environment.rotation * (StrictMath.PI / 180.0)
                return EnvironmentView(
                    map.light, environment.intensity, StrictMath.sin(angle).toFloat(), StrictMath.cos(angle).toFloat(),
                )
            }

            // The horizontal direction to the camera; if it looks down or up, the lower edge of the picture is the
            // front
            var front = camera.toWorldDirection(0.0, 0.0, 1.0)
            if (StrictMath.abs(front.y) > STEEP) {
                front = camera.toWorldDirection(0.0, if (front.y > 0.0) -1.0 else 1.0, 0.0)
            }
            val length = StrictMath.sqrt(front.x * front.x + front.z * front.z)
            val x = (front.x / length).toFloat()
            return EnvironmentView(Studio, environment.intensity, x, (front.z / length).toFloat())
        }

        /** The y of a direction that counts as vertical. */
        private const val STEEP = 0.99
    }
}
