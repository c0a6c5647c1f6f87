package dev.lazyz.sections

import dev.lazyz.Rgba
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.world.material.Material
import kotlin.math.floor

/**
 * Colours a surface with parallel stripes, as caps in technical drawings. The stripes are where planes with the normal
 * (1, 1, 1) meet the surface: on a plane along two axes of the world, they are at 45 degrees. Light has no effect.
 *
 * @property period distance of two such planes times the square root of 3: distance of the stripes along an axis, world
 *   units, above 0
 * @property share width of a stripe, as a part of the period, 0..1
 * @property stripe colour of the stripes
 * @property ground colour between them
 * @throws IllegalArgumentException if a number is out of range
 */
public class Hatching(
    public val period: Double,
    public val share: Double,
    public val stripe: Rgba,
    public val ground: Rgba,
) : Shader {
    init {
        require(period > 0.0 && period.isFinite()) { "period must be positive: $period" }
        require(share in 0.0..1.0) { "share must be in 0..1: $share" }
    }

    override fun shade(fragment: Fragment) {
        val place = (fragment.worldX.toDouble() + fragment.worldY + fragment.worldZ) / period
        val color = if (place - floor(place) < share) stripe else ground
        fragment.setColor(color.red, color.green, color.blue, color.alpha)
    }

    /** Returns a material with these stripes. */
    public fun material(): Material = Material(ground, shader = this)

    override fun toString(): String = "Hatching($period, $share, $stripe, $ground)"
}
