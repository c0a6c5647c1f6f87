package dev.lazyz.world.material

/**
 * A texture that darkens indirect light, where a surface hides itself (contract rule 6.9). Immutable and thread safe.
 *
 * Ambient light and light of the environment are multiplied by `1 + strength * (red - 1)`.
 *
 * @property map the texture, which should have [TextureEncoding.LINEAR]; only its red component is used
 * @property strength 0 for no effect, 1 for the full effect
 * @throws IllegalArgumentException if [strength] is not in 0..1
 */
public class OcclusionMap @JvmOverloads constructor(public val map: TextureMap, public val strength: Float = 1f) {
    init {
        require(strength in 0f..1f) { "strength must be in 0..1: $strength" }
    }

    override fun equals(other: Any?): Boolean =
        other is OcclusionMap && map == other.map && strength.compareTo(other.strength) == 0

    override fun hashCode(): Int = map.hashCode() * 31 + strength.hashCode()

    override fun toString(): String = "OcclusionMap($map, $strength)"
}
