package dev.lazyz.world.material

/**
 * How a physically based material reflects light: the metallic-roughness model of glTF 2.0 (contract rule 6.8).
 * Immutable and thread safe.
 *
 * @property metallic 0 for a dielectric such as plastic, 1 for a metal; between them, a mixture
 * @property roughness 0 for a mirror, 1 for a matt surface. It is the perceptual roughness; its square is the width of
 *   the distribution of microfacets
 * @property map multiplies [roughness] by its green and [metallic] by its blue component; or null. Its texture should
 *   have [Texture.Encoding.LINEAR]
 * @property lobes what it reflects besides; null for nothing
 * @throws IllegalArgumentException if [metallic] or [roughness] is not in 0..1
 */
public class MetallicRoughness @JvmOverloads constructor(
    public val metallic: Float = 1f,
    public val roughness: Float = 1f,
    public val map: TextureMap? = null,
    public val lobes: Lobes? = null,
) {
    init {
        require(metallic in 0f..1f) { "metallic must be in 0..1: $metallic" }
        require(roughness in 0f..1f) { "roughness must be in 0..1: $roughness" }
    }

    /** All maps. */
    internal val maps: List<TextureMap> get() = listOfNotNull(map) + lobes?.maps.orEmpty()

    /** Returns this model with other [lobes], or without any. */
    public fun withLobes(lobes: Lobes?): MetallicRoughness = MetallicRoughness(metallic, roughness, map, lobes)

    /** Returns this model with what [change] makes of each map. */
    internal fun mapped(change: (TextureMap) -> TextureMap?): MetallicRoughness =
        MetallicRoughness(metallic, roughness, map?.let(change), lobes?.mapped(change))

    override fun equals(other: Any?): Boolean = other is MetallicRoughness && map == other.map &&
        lobes == other.lobes && metallic.compareTo(other.metallic) == 0 && roughness.compareTo(other.roughness) == 0

    override fun hashCode(): Int = listOf(metallic, roughness, map, lobes).hashCode()

    override fun toString(): String = "MetallicRoughness($metallic, $roughness, $map, $lobes)"
}
