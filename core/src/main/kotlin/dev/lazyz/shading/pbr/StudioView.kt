package dev.lazyz.shading.pbr

import dev.lazyz.world.Camera
import dev.lazyz.world.Environment

/**
 * The studio as placed around a camera: upright, with its front on the side of the camera. Immutable and thread safe.
 *
 * @param intensity factor of the light
 */
internal class StudioView private constructor(
    private val intensity: Float,
    private val sine: Float,
    private val cosine: Float,
) {
    /** Stores [Studio.radiance] around a direction in world space in [surface]. */
    fun radiance(x: Float, y: Float, z: Float, alpha: Float, surface: FloatArray) {
        val at = PhysicalSurface.RADIANCE
        Studio.radiance(x(x, z), y, z(x, z), alpha, surface, at)
        for (channel in 0 until 3) surface[at + channel] *= intensity
    }

    /** Stores [Studio.irradiance] for a direction in world space in [surface]. */
    fun irradiance(x: Float, y: Float, z: Float, surface: FloatArray) {
        val at = PhysicalSurface.IRRADIANCE
        Studio.irradiance(x(x, z), y, z(x, z), surface, at)
        for (channel in 0 until 3) surface[at + channel] *= intensity
    }

    /** Returns the x in the space of the studio of a direction in world space. */
    private fun x(x: Float, z: Float): Float = cosine * x - sine * z

    /** Returns the z in the space of the studio of a direction in world space. */
    private fun z(x: Float, z: Float): Float = sine * x + cosine * z

    companion object {
        /** Returns the view of [environment] from [camera]; null if there is no environment. */
        fun of(environment: Environment, camera: Camera): StudioView? {
            if (environment == Environment.NONE) return null

            // The horizontal direction to the camera; if it looks down or up, the lower edge of the picture is the
            // front
            var front = camera.toWorldDirection(0.0, 0.0, 1.0)
            if (StrictMath.abs(front.y) > STEEP) {
                front = camera.toWorldDirection(0.0, if (front.y > 0.0) -1.0 else 1.0, 0.0)
            }
            val length = StrictMath.sqrt(front.x * front.x + front.z * front.z)
            return StudioView(environment.intensity, (front.x / length).toFloat(), (front.z / length).toFloat())
        }

        /** The y of a direction that counts as vertical. */
        private const val STEEP = 0.99
    }
}
