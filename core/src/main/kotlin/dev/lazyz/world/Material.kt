package dev.lazyz.world

import dev.lazyz.Rgba
import dev.lazyz.Shader

/** Where on a surface light is evaluated. */
public enum class Shading {
    /** No light: the base colour, the texture and the vertex colours only. */
    CONSTANT,

    /** Once for each face, with the normal of the face: facets are visible. */
    FLAT,

    /** Once for each vertex, with the normal of the vertex; the resulting colours are interpolated (Gouraud 1971). */
    GOURAUD,

    /**
     * At every shaded sample, with the interpolated and renormalised normal; the highlight uses the reflected ray
     * (Phong 1975).
     */
    PHONG,

    /** As [PHONG], but the highlight uses the halfway vector (Blinn 1977). */
    BLINN_PHONG,
}

/** How a material's alpha is used. */
public enum class AlphaMode {
    /** Alpha is ignored; the surface is opaque. */
    OPAQUE,

    /** Samples whose alpha is below the material's cutoff are not covered; the others are opaque. */
    MASK,

    /** Alpha is part of the colour, for renderers that blend. */
    BLEND,
}

/** Which sides of a surface are drawn. */
public enum class Sides {
    /** Both sides; on the back, the normal is reversed so that it faces the viewer. */
    BOTH,

    /** Only the front, from which the vertices are in counter-clockwise order. */
    FRONT,
}

/**
 * The appearance of a surface.
 *
 * The base colour is multiplied by the texture and by the vertex colours if the surface has them. Immutable and thread
 * safe; any number of surfaces can share a material.
 *
 * @property baseColor diffuse colour and opacity, linear light
 * @property texture multiplies the base colour; null for none
 * @property shading where light is evaluated; ignored if [shader] is given
 * @property specular colour of highlights, linear light
 * @property shininess exponent of the highlight, an integer in 1..1024, so that the power is a product (contract rule
 *   6.3)
 * @property emission light that the surface emits, linear light
 * @property alphaMode how alpha is used
 * @property alphaCutoff smallest alpha that is covered under [AlphaMode.MASK], 0..1
 * @property sides which sides are drawn
 * @property shader a custom shader that replaces [shading] and the lights, or null
 * @property name name for messages and files
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
     * Whether samples of this material can be translucent: [AlphaMode.BLEND], with alpha below 1 in the base colour or
     * the texture, or with a custom shader. Vertex colours can make a surface translucent too, but are not considered
     * here.
     */
    public val isTranslucent: Boolean
        get() = alphaMode == AlphaMode.BLEND &&
            (!(baseColor.alpha >= 1f) || texture?.hasAlpha == true || shader != null)

    /** Whether textures are read with the derivatives of their coordinates. */
    internal val usesFootprint: Boolean get() = texture != null && texture.mipFilter != MipFilter.NONE

    /** Returns this material with another [baseColor]. */
    public fun withBaseColor(baseColor: Rgba): Material = copy(baseColor = baseColor)

    /** Returns this material with another [texture], or without one. */
    public fun withTexture(texture: Texture?): Material = copy(texture = texture)

    /** Returns this material with another [shading]. */
    public fun withShading(shading: Shading): Material = copy(shading = shading)

    /** Returns this material with another colour of highlights. */
    public fun withSpecular(specular: Rgba): Material = copy(specular = specular)

    /** Returns this material with another exponent of highlights, 1..1024. */
    public fun withShininess(shininess: Int): Material = copy(shininess = shininess)

    /** Returns this material with other emitted light. */
    public fun withEmission(emission: Rgba): Material = copy(emission = emission)

    /** Returns this material with another meaning of alpha. */
    public fun withAlphaMode(alphaMode: AlphaMode): Material = copy(alphaMode = alphaMode)

    /** Returns this material with another smallest alpha that [AlphaMode.MASK] covers, 0..1. */
    public fun withAlphaCutoff(alphaCutoff: Float): Material = copy(alphaCutoff = alphaCutoff)

    /** Returns this material with other sides drawn. */
    public fun withSides(sides: Sides): Material = copy(sides = sides)

    /** Returns this material with the custom [shader], which replaces shading and lights, or without one. */
    public fun withShader(shader: Shader?): Material = copy(shader = shader)

    /** Returns this material with another [name]. */
    public fun withName(name: String): Material = copy(name = name)

    private fun copy(
        baseColor: Rgba = this.baseColor,
        texture: Texture? = this.texture,
        shading: Shading = this.shading,
        specular: Rgba = this.specular,
        shininess: Int = this.shininess,
        emission: Rgba = this.emission,
        alphaMode: AlphaMode = this.alphaMode,
        alphaCutoff: Float = this.alphaCutoff,
        sides: Sides = this.sides,
        shader: Shader? = this.shader,
        name: String = this.name,
    ): Material = Material(
        baseColor, texture, shading, specular, shininess, emission, alphaMode, alphaCutoff, sides, shader, name,
    )

    override fun toString(): String = "Material(\"$name\", $baseColor, $shading, texture=$texture)"
}
