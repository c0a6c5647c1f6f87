package dev.lazyz.world

/**
 * How the light of a point or a spot decreases with the distance (contract rule 6.5). Immutable and thread safe.
 *
 * @property isInverseSquare whether the light is divided by the square of the distance, in world units
 * @property range distance at which the light reaches 0, world units; infinite for none. Below it, the light is
 *   multiplied by `1 - (distance / range)^4`, as in the glTF extension `KHR_lights_punctual`
 */
public class Falloff private constructor(public val isInverseSquare: Boolean, public val range: Double) {
    override fun equals(other: Any?): Boolean =
        other is Falloff && isInverseSquare == other.isInverseSquare && range.compareTo(other.range) == 0

    override fun hashCode(): Int = range.hashCode() * 2 + (if (isInverseSquare) 1 else 0)

    override fun toString(): String = if (isInverseSquare) "Falloff.inverseSquare($range)" else "Falloff.NONE"

    public companion object {
        /** The same strength at any distance. */
        @JvmField
        public val NONE: Falloff = Falloff(false, Double.POSITIVE_INFINITY)

        /**
         * Returns the falloff of a real light, which reaches up to [range].
         *
         * @throws IllegalArgumentException if [range] is not above 0
         */
        @JvmStatic
        @JvmOverloads
        public fun inverseSquare(range: Double = Double.POSITIVE_INFINITY): Falloff {
            require(range > 0.0) { "range of a light must be above 0: $range" }
            return Falloff(true, range)
        }
    }
}
