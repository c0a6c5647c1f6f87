package dev.lazyz.world

import dev.lazyz.Rgba
import dev.lazyz.geometry.Vectors
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A light source, in world space. Immutable and thread safe.
 *
 * Colours are linear light and can exceed 1. Only the three kinds below exist, because the lighting formula is part of
 * the contract (rule 6.5). For other light, write a custom shader.
 */
public sealed class Light {
    /** Colour and strength of the light, linear; alpha is ignored. */
    public abstract val color: Rgba

    /** Returns this light relative to [origin]. */
    internal open fun relativeTo(origin: Vector3dc): Light = this

    /** Returns this light rotated so that the axis [up] becomes y. */
    internal open fun withUpAxis(up: UpAxis): Light = this

    /** Ambient light, equal on every surface. */
    public class Ambient(override val color: Rgba) : Light() {
        override fun toString(): String = "Light.Ambient($color)"
    }

    /** Parallel light, like sunlight, that travels along [direction]. */
    public class Directional(direction: Vector3dc, override val color: Rgba) : Light() {
        /** The direction in which the light travels; unit length. */
        public val direction: Vector3dc = Vectors.unit(direction, "direction of a light")

        override fun withUpAxis(up: UpAxis): Directional = Directional(up.toWorld(direction), color)

        override fun toString(): String = "Light.Directional($direction, $color)"
    }

    /**
     * Light from a point in all directions, with the same strength at any distance.
     *
     * @throws IllegalArgumentException if [position] is not finite
     */
    public class Point(position: Vector3dc, override val color: Rgba) : Light() {
        /** Position of the light, world space. */
        public val position: Vector3dc = Vector3d(position)

        init {
            require(Vectors.isFinite(position)) { "position of a light must be finite: $position" }
        }

        override fun relativeTo(origin: Vector3dc): Point = Point(Vectors.minus(position, origin), color)

        override fun withUpAxis(up: UpAxis): Point = Point(up.toWorld(position), color)

        override fun toString(): String = "Light.Point($position, $color)"
    }

    public companion object {
        /**
         * Returns lights that make a shape readable from [camera]: a key light from the upper left, a weak fill light
         * from the right, and a little ambient light. Their directions are relative to the camera. A white surface
         * stays darker than white, so that it is visible in front of a white background.
         */
        @JvmStatic
        public fun studio(camera: Camera): List<Light> = listOf(
            Ambient(Rgba(0.060f, 0.062f, 0.068f)),
            Directional(camera.toWorldDirection(0.55, -0.75, -0.85), Rgba(0.62f, 0.61f, 0.59f)),
            Directional(camera.toWorldDirection(-0.90, 0.05, -0.45), Rgba(0.11f, 0.125f, 0.15f)),
        )
    }
}
