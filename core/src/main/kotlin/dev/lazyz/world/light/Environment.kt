package dev.lazyz.world.light

import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.MetallicRoughness
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Light from all directions that materials with [MetallicRoughness] reflect (contract rule 6.10). Immutable and thread
 * safe.
 *
 * It is a photographer's studio, or a picture of real surroundings. The studio has grey walls, and soft boxes at the
 * upper left, at the right, above and behind; it turns with the camera, but stays upright. A picture stays in place.
 * Other materials do not reflect either.
 *
 * @property intensity factor of all its light; 0 for no environment
 * @property map the picture, or null for the studio
 * @property rotation where the middle of the picture is, degrees around the y axis: 0 in front, at z, and 90 at the
 *   right, at x
 * @throws IllegalArgumentException if [intensity] is negative or not finite, or [rotation] is not finite
 */
public class Environment private constructor(
    public val intensity: Float,
    public val map: EnvironmentMap?,
    public val rotation: Double,
) {
    init {
        require(intensity >= 0f && intensity.isFinite()) {
            "intensity of an environment must be 0 or more: $intensity"
        }
        require(rotation.isFinite()) { "rotation of an environment must be finite: $rotation" }
    }

    /** Returns this environment with its light multiplied by [factor]. */
    internal fun scaled(factor: Float): Environment =
        Environment(minOf(intensity * factor, Float.MAX_VALUE), map, rotation)

    override fun equals(other: Any?): Boolean = other is Environment && map === other.map &&
        intensity.compareTo(other.intensity) == 0 && rotation.compareTo(other.rotation) == 0

    override fun hashCode(): Int = intensity.hashCode() + 31 * rotation.hashCode()

    override fun toString(): String =
        if (map == null) "Environment.studio($intensity)" else "Environment.of($map, $intensity, $rotation)"

    public companion object {
        /** No environment: metals only reflect the lights of the scene. */
        @JvmField
        public val NONE: Environment = Environment(0f, null, 0.0)

        /**
         * The studio with 0.7 of its light: a white surface stays darker than white, so that it is visible in front of
         * a white background.
         */
        @JvmField
        public val USUAL: Environment = Environment(0.7f, null, 0.0)

        /**
         * The studio with 0.3 of its light, for scenes with lights of their own: metals have something to reflect, and
         * white surfaces stay darker than white.
         */
        @JvmField
        public val FAINT: Environment = Environment(0.3f, null, 0.0)

        /** Returns the studio, with its light multiplied by [intensity], 0 or more. */
        @JvmStatic
        @JvmOverloads
        public fun studio(intensity: Float = 1f): Environment = Environment(intensity, null, 0.0)

        /** Returns the surroundings in a picture; see the properties. */
        @JvmStatic
        @JvmOverloads
        public fun of(map: EnvironmentMap, intensity: Float = 1f, rotation: Double = 0.0): Environment =
            Environment(intensity, map, rotation)
    }
}

/**
 * How much of the light from all sides reaches a point. `Scene.withAmbientVisibility` multiplies ambient light and the
 * [Environment] by it, like an [OcclusionMap] (contract rule 6.13). `AmbientOcclusion` computes it from the shapes of a
 * scene.
 *
 * Must be a pure function with the arithmetic of contract rule 6.3, and thread safe: it is called for each shaded
 * sample, by any thread, in any order.
 */
public fun interface AmbientVisibility {
    /**
     * Returns the part of the light that reaches a point, 0..1.
     *
     * @param x the point in world space, relative to `Scene.origin`; the same for [y] and [z]
     * @param normalX the normal at the point, unit length, on the viewer's side; the same for [normalY] and [normalZ]
     */
    public fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float): Float
}

/**
 * A [visibility] in a scene that was rotated so that the axis [up] became y.
 *
 * @property shift origin of the rotated scene, relative to that of the scene before, in the space before
 */
internal class TurnedVisibility(
    private val visibility: AmbientVisibility,
    private val up: UpAxis,
    private val shift: Vector3dc,
) : AmbientVisibility {
    override fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float): Float {
        val point = up.toModel(Vector3d(x.toDouble(), y.toDouble(), z.toDouble())).add(shift)
        val normal = up.toModel(Vector3d(normalX.toDouble(), normalY.toDouble(), normalZ.toDouble()))
        return visibility.at(
            point.x.toFloat(), point.y.toFloat(), point.z.toFloat(),
            normal.x.toFloat(), normal.y.toFloat(), normal.z.toFloat(),
        )
    }
}
