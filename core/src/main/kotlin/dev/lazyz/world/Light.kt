package dev.lazyz.world

import dev.lazyz.Rgba
import dev.lazyz.geometry.Vectors
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A source of light, in world space. Immutable and thread safe.
 *
 * Colours are linear light and may exceed 1. Only the three kinds below exist: the lighting formula is part of the
 * contract (rule 6.5). A shader of one's own may do anything else.
 */
public sealed class Light {
    /** The light's colour and strength, linear; alpha is ignored. */
    public abstract val color: Rgba

    /** Returns this light as it is seen from [origin]. */
    internal open fun relativeTo(origin: Vector3dc): Light = this

    /** Light from everywhere, the same on every surface. */
    public class Ambient(override val color: Rgba) : Light() {
        override fun toString(): String = "Light.Ambient($color)"
    }

    /**
     * Parallel light, as from the sun, that travels along [direction].
     *
     * @throws IllegalArgumentException if [direction] is zero or not finite
     */
    public class Directional(direction: Vector3dc, override val color: Rgba) : Light() {
        /** The way the light travels; unit length. */
        public val direction: Vector3dc = Vectors.unit(direction, "direction of a light")

        override fun toString(): String = "Light.Directional($direction, $color)"
    }

    /** Light from a point in all directions, the same strength at any distance. */
    public class Point(position: Vector3dc, override val color: Rgba) : Light() {
        /** Where the light is. */
        public val position: Vector3dc = Vector3d(position)

        init {
            require(Vectors.isFinite(position)) { "position of a light must be finite: $position" }
        }

        override fun relativeTo(origin: Vector3dc): Point = Point(Vectors.minus(position, origin), color)

        override fun toString(): String = "Light.Point($position, $color)"
    }

    public companion object {
        /**
         * Returns lights that make a bare shape readable from [camera]: a key light from the upper left, a weak fill
         * from the right, and a little ambient light, all fixed to the camera. A white surface stays darker than white,
         * so that it can be told from a white background.
         */
        @JvmStatic
        public fun studio(camera: Camera): List<Light> = listOf(
            Ambient(Rgba(0.060f, 0.062f, 0.068f)),
            Directional(camera.toWorldDirection(0.55, -0.75, -0.85), Rgba(0.62f, 0.61f, 0.59f)),
            Directional(camera.toWorldDirection(-0.90, 0.05, -0.45), Rgba(0.11f, 0.125f, 0.15f)),
        )
    }
}
