package dev.lazyz.world.material

/**
 * A texture and how it is laid on a surface. Immutable and thread safe.
 *
 * @property texture the image
 * @property uvSet which texture coordinates of the surface are used: 0 for the first set, 1 for the second. A surface
 *   without that set is treated as if it had the coordinates (0, 0) everywhere
 * @property transform applied to the coordinates at each sample
 * @throws IllegalArgumentException if [uvSet] is neither 0 nor 1
 */
public class TextureMap @JvmOverloads constructor(
    public val texture: Texture,
    public val uvSet: Int = 0,
    public val transform: UvTransform = UvTransform.IDENTITY,
) {
    init {
        require(uvSet in 0..1) { "uvSet must be 0 or 1: $uvSet" }
    }

    /** Returns this map with another [texture]. */
    public fun withTexture(texture: Texture): TextureMap = TextureMap(texture, uvSet, transform)

    override fun equals(other: Any?): Boolean =
        other is TextureMap && texture === other.texture && uvSet == other.uvSet && transform == other.transform

    override fun hashCode(): Int = (System.identityHashCode(texture) * 31 + uvSet) * 31 + transform.hashCode()

    override fun toString(): String = "TextureMap($texture, uvSet=$uvSet, $transform)"
}
