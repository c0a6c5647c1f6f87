package dev.lazyz.world

import dev.lazyz.world.material.MetallicRoughness

/**
 * Light from all directions that materials with [MetallicRoughness] reflect (contract rule 6.10). Immutable and thread
 * safe.
 *
 * There is one kind of environment, a photographer's studio: grey walls, and soft boxes at the upper left, at the
 * right, above and behind. It turns with the camera, but stays upright. Other materials do not reflect it.
 *
 * @property intensity factor of all its light; 0 for no environment
 * @throws IllegalArgumentException if [intensity] is negative or not finite
 */
public class Environment private constructor(public val intensity: Float) {
    init {
        require(intensity >= 0f && intensity.isFinite()) {
            "intensity of an environment must be 0 or more: $intensity"
        }
    }

    override fun equals(other: Any?): Boolean = other is Environment && intensity.compareTo(other.intensity) == 0

    override fun hashCode(): Int = intensity.hashCode()

    override fun toString(): String = "Environment.studio($intensity)"

    public companion object {
        /** No environment: metals only reflect the lights of the scene. */
        @JvmField
        public val NONE: Environment = Environment(0f)

        /**
         * The studio with 0.7 of its light: a white surface stays darker than white, so that it is visible in front of
         * a white background.
         */
        @JvmField
        public val USUAL: Environment = Environment(0.7f)

        /**
         * The studio with 0.3 of its light, for scenes with lights of their own: metals have something to reflect, and
         * white surfaces stay darker than white.
         */
        @JvmField
        public val FAINT: Environment = Environment(0.3f)

        /** Returns the studio, with its light multiplied by [intensity], 0 or more. */
        @JvmStatic
        @JvmOverloads
        public fun studio(intensity: Float = 1f): Environment = Environment(intensity)
    }
}
