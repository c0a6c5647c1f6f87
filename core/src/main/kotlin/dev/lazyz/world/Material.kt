package dev.lazyz.world

import dev.lazyz.Rgba
import dev.lazyz.Shader

/** Where light is evaluated on a surface. */
public enum class Shading {
    /** No light at all: the base colour, the texture and the vertex colours as they are. */
    CONSTANT,

    /** Once a face, with the face's own normal: facets show. */
    FLAT,

    /** Once a vertex, with the vertex's normal; the resulting colours are interpolated (Gouraud 1971). */
    GOURAUD,

    /** At every shaded sample, with the interpolated, renormalised normal; highlight by the reflected ray (Phong 1975). */
    PHONG,

    /** As [PHONG], with the highlight by the halfway vector (Blinn 1977). */
    BLINN_PHONG,
}

/** What a material's alpha does. */
public enum class AlphaMode {
    /** Alpha is ignored; the surface is opaque. */
    OPAQUE,

    /** A sample whose alpha is below the material's cutoff is not covered at all; the rest is opaque. */
    MASK,

    /** Alpha is kept in the colour, for renderers that blend. */
    BLEND,
}

/** Which sides of a surface are drawn. */
public enum class Sides {
    /** Both; the normal of the side seen from behind is turned to the viewer. */
    BOTH,

    /** Only the side from which the vertices run counter-clockwise. */
    FRONT,
}

/**
 * How a surface looks.
 *
 * The base colour is multiplied by the texture and by the vertex colours where a surface has them. Immutable and thread
 * safe; one material serves any number of surfaces.
 *
 * @property baseColor diffuse colour and opacity, linear light
 * @property texture multiplies the base colour, or null
 * @property shading where light is evaluated; ignored when [shader] is given
 * @property specular colour of highlights, linear light
 * @property shininess the highlight's exponent, an integer in 1..1024, so that the power is a product (contract rule 6.3)
 * @property emission light that the surface gives off by itself, linear light
 * @property alphaMode what alpha does
 * @property alphaCutoff least alpha that is covered under [AlphaMode.MASK], 0..1
 * @property sides which sides are drawn
 * @property shader a shader of the user's own that replaces [shading] and lights, or null
 * @property name for messages and files
 * @throws IllegalArgumentException if [shininess] or [alphaCutoff] is out of range
 */
public class Material @JvmOverloads constructor(
    public val baseColor: Rgba = Rgba.WHITE,
    public val texture: Texture? = null,
    public val shading: Shading = Shading.PHONG,
    public val specular: Rgba = Rgba.BLACK,
    public val shininess: Int = 32,
    public val emission: Rgba = Rgba.BLACK,
    public val alphaMode: AlphaMode = AlphaMode.OPAQUE,
    public val alphaCutoff: Float = 0.5f,
    public val sides: Sides = Sides.BOTH,
    public val shader: Shader? = null,
    public val name: String = "",
) {
    init {
        require(shininess in 1..1024) { "shininess must be in 1..1024: $shininess" }
        require(alphaCutoff in 0f..1f) { "alphaCutoff must be in 0..1: $alphaCutoff" }
    }

    /**
     * Whether a sample of this material may let through what lies behind it: [AlphaMode.BLEND] with alpha below 1 in the
     * base colour or the texture, or with a shader of the user's own. Vertex colours may make it so besides.
     */
    public val isTranslucent: Boolean
        get() = alphaMode == AlphaMode.BLEND &&
            (!(baseColor.alpha >= 1f) || texture?.hasAlpha == true || shader != null)

    /** Returns this material with light evaluated elsewhere. */
    public fun withShading(shading: Shading): Material = Material(
        baseColor, texture, shading, specular, shininess, emission, alphaMode, alphaCutoff, sides, shader, name,
    )

    /** Returns this material coloured by [shader] alone. */
    public fun withShader(shader: Shader): Material = Material(
        baseColor, texture, shading, specular, shininess, emission, alphaMode, alphaCutoff, sides, shader, name,
    )

    override fun toString(): String = "Material(\"$name\", $baseColor, $shading, texture=$texture)"
}
