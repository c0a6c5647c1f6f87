package dev.lazyz.world.light

import dev.lazyz.Rgba
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.MetallicRoughness
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A light source, in world space. Immutable and thread safe.
 *
 * Colours are linear light and can exceed 1. A matt white surface that a light of colour 1 reaches at a right angle is
 * white. Only the four kinds below exist, because the lighting formula is part of the contract (rules 6.5 and 6.8). For
 * other light, write a custom shader.
 */
public sealed class Light {
    /** Colour and strength of the light, linear; alpha is ignored. */
    public abstract val color: Rgba

    /** Returns this light relative to [origin]. */
    internal open fun relativeTo(origin: Vector3dc): Light = this

    /** Returns this light rotated so that the axis [up] becomes y. */
    internal open fun withUpAxis(up: UpAxis): Light = this

    /** Returns this light with its colour multiplied by [factor]. */
    public abstract fun scaled(factor: Float): Light

    /** Ambient light, equal on every surface. */
    public class Ambient(override val color: Rgba) : Light() {
        override fun scaled(factor: Float): Ambient = Ambient(color.scaled(factor))

        override fun toString(): String = "Light.Ambient($color)"
    }

    /** Parallel light, like sunlight, that travels along [direction]. */
    public class Directional(direction: Vector3dc, override val color: Rgba) : Light() {
        /** The direction in which the light travels; unit length. */
        public val direction: Vector3dc = Vectors.unit(direction, "direction of a light")

        override fun withUpAxis(up: UpAxis): Directional = Directional(up.toWorld(direction), color)

        override fun scaled(factor: Float): Directional = Directional(direction, color.scaled(factor))

        override fun toString(): String = "Light.Directional($direction, $color)"
    }

    /**
     * Light from a point in all directions.
     *
     * @property falloff how it decreases with the distance. The strength of [color] is that at the distance 1
     * @throws IllegalArgumentException if [position] is not finite
     */
    public class Point @JvmOverloads constructor(
        position: Vector3dc,
        override val color: Rgba,
        public val falloff: Falloff = Falloff.NONE,
    ) : Light() {
        /** Position of the light, world space. */
        public val position: Vector3dc = Vector3d(position)

        init {
            require(Vectors.isFinite(position)) { "position of a light must be finite: $position" }
        }

        override fun relativeTo(origin: Vector3dc): Point = Point(Vectors.minus(position, origin), color, falloff)

        override fun withUpAxis(up: UpAxis): Point = Point(up.toWorld(position), color, falloff)

        override fun scaled(factor: Float): Point = Point(position, color.scaled(factor), falloff)

        override fun toString(): String = "Light.Point($position, $color, $falloff)"
    }

    /**
     * Light from a point into a cone, with a soft edge as in the glTF extension `KHR_lights_punctual`.
     *
     * @property innerAngle degrees between the axis of the cone and the start of its soft edge, 0 or more
     * @property outerAngle degrees between the axis and the end of the light, above [innerAngle], at most 90
     * @property falloff how the light decreases with the distance. The strength of [color] is that at the distance 1
     * @throws IllegalArgumentException if [position] is not finite, [direction] has no length, or an angle is out of
     *   range
     */
    public class Spot @JvmOverloads constructor(
        position: Vector3dc,
        direction: Vector3dc,
        override val color: Rgba,
        public val innerAngle: Double = 0.0,
        public val outerAngle: Double = 45.0,
        public val falloff: Falloff = Falloff.NONE,
    ) : Light() {
        /** Position of the light, world space. */
        public val position: Vector3dc = Vector3d(position)

        /** The axis of the cone, in the direction in which the light travels; unit length. */
        public val direction: Vector3dc = Vectors.unit(direction, "direction of a light")

        init {
            require(Vectors.isFinite(position)) { "position of a light must be finite: $position" }
            require(innerAngle >= 0.0 && innerAngle < outerAngle && outerAngle <= 90.0) {
                "angles of a spot must be 0 <= inner < outer <= 90: $innerAngle, $outerAngle"
            }
        }

        override fun relativeTo(origin: Vector3dc): Spot =
            Spot(Vectors.minus(position, origin), direction, color, innerAngle, outerAngle, falloff)

        override fun withUpAxis(up: UpAxis): Spot =
            Spot(up.toWorld(position), up.toWorld(direction), color, innerAngle, outerAngle, falloff)

        override fun scaled(factor: Float): Spot =
            Spot(position, direction, color.scaled(factor), innerAngle, outerAngle, falloff)

        override fun toString(): String =
            "Light.Spot($position, $direction, $color, $innerAngle..$outerAngle degrees, $falloff)"
    }

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

/**
 * All light of a scene, and how it becomes the colours of a picture.
 *
 * @property classical the lights of materials without [MetallicRoughness]
 * @property physical the lights of materials with it
 * @property environment what the latter reflect besides
 * @property toneMapping exposure and tone curve
 * @property visibility which part of ambient light and of the environment reaches a point; null for all of it
 */
internal class SceneLight(
    val classical: List<Light>,
    val physical: List<Light>,
    val environment: Environment,
    val toneMapping: ToneMapping,
    val visibility: AmbientVisibility?,
) {
    /** Returns the same light relative to [origin]. */
    fun relativeTo(origin: Vector3dc): SceneLight = SceneLight(
        classical.map { it.relativeTo(origin) },
        physical.map { it.relativeTo(origin) },
        environment,
        toneMapping,
        visibility,
    )
}
