package dev.lazyz.world.material

/**
 * A texture that changes the normals of a surface at each sample (contract rule 6.9). Immutable and thread safe.
 *
 * Red, green and blue are the components of a normal, from -1 (code 0) to 1 (code 255): along the tangent, along the
 * bitangent, and along the normal of the surface, as in glTF 2.0, section 3.9.3. The tangents of the surface must
 * belong to the texture coordinates of [map]. Where a surface has no tangents, its normals are not changed.
 *
 * @property map the texture, which should have [TextureEncoding.LINEAR]
 * @property scale factor of the red and green components
 * @throws IllegalArgumentException if [scale] is not finite
 */
public class NormalMap @JvmOverloads constructor(public val map: TextureMap, public val scale: Float = 1f) {
    init {
        require(scale.isFinite()) { "scale of a normal map must be finite: $scale" }
    }

    override fun equals(other: Any?): Boolean =
        other is NormalMap && map == other.map && scale.compareTo(other.scale) == 0

    override fun hashCode(): Int = map.hashCode() * 31 + scale.hashCode()

    override fun toString(): String = "NormalMap($map, $scale)"
}
