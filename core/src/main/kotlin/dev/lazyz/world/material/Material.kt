package dev.lazyz.world.material

import dev.lazyz.Rgba
import dev.lazyz.spi.Shader
import dev.lazyz.world.material.Texture.MipFilter
import java.util.function.IntPredicate

/**
 * The appearance of a surface.
 *
 * The base colour is multiplied by the texture and by the vertex colours if the surface has them. There are two kinds
 * of materials: classical ones, whose light is computed as [shading] says, and, with [metallicRoughness], physically
 * based ones. Maps vary either over the surface: see [withNormalMap], [withOcclusionMap] and [withEmissionMap].
 * Immutable and thread safe; any number of surfaces can share a material.
 *
 * @property baseColor diffuse colour and opacity, linear light; for metals, the colour of what they reflect. The
 *   opacity has an effect only with [AlphaMode.BLEND] or [AlphaMode.MASK], not with the default, [AlphaMode.OPAQUE]
 * @property shading where light is evaluated; ignored if [shader] is given. With [metallicRoughness], it is at every
 *   shaded sample, unless this is [Shading.CONSTANT]
 * @property specular colour of highlights, linear light; not used with [metallicRoughness]
 * @property shininess exponent of the highlight, an integer in 1..1024, so that the power is a product (contract rule
 *   6.3); not used with [metallicRoughness]
 * @property emission light that the surface emits, linear light; components can exceed 1
 * @property alphaMode how alpha is used
 * @property alphaCutoff smallest alpha that is covered under [AlphaMode.MASK], 0..1
 * @property sides which sides are drawn
 * @property shader a custom shader that replaces [shading] and the lights, or null
 * @property name name for messages and files
 * @property textureMap multiplies the base colour; null for none
 * @property metallicRoughness how a physically based material reflects light; null for a classical material
 * @property normalMap changes the normals at each sample; null for none
 * @property occlusionMap darkens indirect light at each sample; null for none
 * @property emissionMap multiplies [emission]; null for none
 */
public class Material private constructor(
    public val baseColor: Rgba,
    public val textureMap: TextureMap?,
    public val shading: Shading,
    public val specular: Rgba,
    public val shininess: Int,
    public val emission: Rgba,
    public val alphaMode: AlphaMode,
    public val alphaCutoff: Float,
    public val sides: Sides,
    public val shader: Shader?,
    public val name: String,
    public val metallicRoughness: MetallicRoughness?,
    public val normalMap: NormalMap?,
    public val occlusionMap: OcclusionMap?,
    public val emissionMap: TextureMap?,
) {
    /**
     * Creates a material without maps, except for a [texture]; see the properties. The functions `with...` set the
     * others. It is opaque, whatever the alpha of [baseColor], unless [alphaMode] says something else:
     * `Material(color).withAlphaMode(AlphaMode.BLEND)` shows what is behind it.
     *
     * @param texture multiplies the base colour; null for none
     * @throws IllegalArgumentException if [shininess] or [alphaCutoff] is out of range
     */
    @JvmOverloads
    public constructor(
        baseColor: Rgba = Rgba.WHITE,
        texture: Texture? = null,
        shading: Shading = Shading.PHONG,
        specular: Rgba = Rgba.BLACK,
        shininess: Int = 32,
        emission: Rgba = Rgba.BLACK,
        alphaMode: AlphaMode = AlphaMode.OPAQUE,
        alphaCutoff: Float = 0.5f,
        sides: Sides = Sides.BOTH,
        shader: Shader? = null,
        name: String = "",
    ) : this(
        baseColor, texture?.let { TextureMap(it) }, shading, specular, shininess, emission, alphaMode, alphaCutoff,
        sides, shader, name, null, null, null, null,
    )

    init {
        require(shininess in 1..1024) { "shininess must be in 1..1024: $shininess" }
        require(alphaCutoff in 0f..1f) { "alphaCutoff must be in 0..1: $alphaCutoff" }
    }

    /** The texture of [textureMap]. */
    public val texture: Texture? get() = textureMap?.texture

    /**
     * Whether samples of this material can be translucent: [AlphaMode.BLEND], with alpha below 1 in the base colour or
     * the texture, with a custom shader, or with [Lobes.Transmission]. Vertex colours can make a surface translucent
     * too, but are not considered here.
     */
    public val isTranslucent: Boolean
        get() = alphaMode == AlphaMode.BLEND &&
            (!(baseColor.alpha >= 1f) || texture?.hasAlpha == true || shader != null || isGlass)

    private val isGlass get() = isPhysical && metallicRoughness?.lobes?.transmission != null

    /** Whether light is computed by the metallic-roughness model. */
    internal val isPhysical: Boolean
        get() = metallicRoughness != null && shading != Shading.CONSTANT && shader == null

    /** Whether light is computed during set-up, at vertices or faces. */
    internal val isLitEarly: Boolean
        get() = shader == null && metallicRoughness == null && (shading == Shading.FLAT || shading == Shading.GOURAUD)

    /** Whether light is computed at samples, or a custom shader may do so. */
    internal val isLitLate: Boolean
        get() = shader != null || isPhysical || shading == Shading.PHONG || shading == Shading.BLINN_PHONG

    /** All maps that are read. Normal and occlusion maps have an effect only where light is computed at samples. */
    internal val maps: List<TextureMap>
        get() = listOfNotNull(textureMap, emissionMap) + if (!isLitLate) {
            emptyList()
        } else {
            metallicRoughness?.maps.orEmpty().filter { isPhysical } + listOfNotNull(normalMap?.map, occlusionMap?.map)
        }

    /** The sets of texture coordinates that maps use, also where light is not computed at samples. */
    internal val uvSets: Set<Int>
        get() = (
            listOfNotNull(textureMap, emissionMap, normalMap?.map, occlusionMap?.map) +
                metallicRoughness?.maps.orEmpty()
            ).mapTo(HashSet()) { it.uvSet }

    /** Whether the tangents of a surface change how it looks. */
    public val usesTangents: Boolean get() = tangentMap != null || metallicRoughness?.lobes?.anisotropy != null

    /**
     * The map to whose texture coordinates the tangents of a surface must belong; null if there is none. If the
     * material uses tangents nevertheless, they belong to the first set of texture coordinates.
     */
    public val tangentMap: TextureMap?
        get() = normalMap?.map ?: metallicRoughness?.lobes?.run { clearcoat?.normalMap?.map ?: anisotropy?.map }

    /** Whether textures are read with the derivatives of their coordinates. */
    internal val usesFootprint: Boolean get() = maps.any { it.texture.mipFilter != MipFilter.NONE }

    /** Returns this material with another [baseColor], whose alpha counts as [alphaMode] says. */
    public fun withBaseColor(baseColor: Rgba): Material = copy(baseColor = baseColor)

    /** Returns this material with another [texture], or without one. */
    public fun withTexture(texture: Texture?): Material = copy(textureMap = texture?.let { TextureMap(it) })

    /** Returns this material with another texture and its place on the surface, or without one. */
    public fun withTextureMap(textureMap: TextureMap?): Material = copy(textureMap = textureMap)

    /** Returns this material as a physically based one, or, with null, as a classical one. */
    public fun withMetallicRoughness(metallicRoughness: MetallicRoughness?): Material =
        copy(metallicRoughness = metallicRoughness)

    /**
     * Returns this material as a physically based one that looks similar: a matt dielectric, or, if [specular] is not
     * black, one with highlights of the same width. Unlit, custom and physically based materials stay as they are.
     */
    public fun asMetallicRoughness(): Material {
        if (metallicRoughness != null || shader != null || shading == Shading.CONSTANT) return this
        val isShiny = specular.red > 0f || specular.green > 0f || specular.blue > 0f

        // The distributions of Blinn and GGX have the same width for alpha^2 = 2 / (n + 2), and alpha is roughness^2
        val roughness = if (isShiny) StrictMath.sqrt(StrictMath.sqrt(2.0 / (shininess + 2.0))).toFloat() else 1f
        return copy(metallicRoughness = MetallicRoughness(metallic = 0f, roughness = roughness))
    }

    /**
     * Returns this material with another normal map, or without one. It has an effect if light is evaluated at samples:
     * with [metallicRoughness], [Shading.PHONG] or [Shading.BLINN_PHONG].
     */
    public fun withNormalMap(normalMap: NormalMap?): Material = copy(normalMap = normalMap)

    /**
     * Returns this material with another occlusion map, or without one. It has an effect where normal maps have one.
     */
    public fun withOcclusionMap(occlusionMap: OcclusionMap?): Material = copy(occlusionMap = occlusionMap)

    /** Returns this material with another texture that multiplies [emission], or without one. */
    public fun withEmissionMap(emissionMap: TextureMap?): Material = copy(emissionMap = emissionMap)

    /** Returns this material with the [mipFilter] in the textures of all its maps. */
    public fun withMipFilter(mipFilter: MipFilter): Material {
        fun filtered(map: TextureMap) = map.withTexture(map.texture.withMipFilter(mipFilter))
        return copy(
            textureMap = textureMap?.let(::filtered),
            metallicRoughness = metallicRoughness?.mapped(::filtered),
            normalMap = normalMap?.let { NormalMap(filtered(it.map), it.scale) },
            occlusionMap = occlusionMap?.let { OcclusionMap(filtered(it.map), it.strength) },
            emissionMap = emissionMap?.let(::filtered),
        )
    }

    /** Returns this material without any map or texture, for a surface without texture coordinates. */
    public fun withoutMaps(): Material = withMapsOf { false }

    /**
     * Returns this material with those maps only whose set of texture coordinates, 0 or 1, a surface has.
     *
     * @param hasUvSet whether the surface has the set of this number
     */
    public fun withMapsOf(hasUvSet: IntPredicate): Material {
        fun isKept(map: TextureMap) = hasUvSet.test(map.uvSet)
        return copy(
            textureMap = textureMap?.takeIf(::isKept),
            metallicRoughness = metallicRoughness?.mapped { map -> map.takeIf(::isKept) },
            normalMap = normalMap?.takeIf { isKept(it.map) },
            occlusionMap = occlusionMap?.takeIf { isKept(it.map) },
            emissionMap = emissionMap?.takeIf(::isKept),
        )
    }

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
        textureMap: TextureMap? = this.textureMap,
        shading: Shading = this.shading,
        specular: Rgba = this.specular,
        shininess: Int = this.shininess,
        emission: Rgba = this.emission,
        alphaMode: AlphaMode = this.alphaMode,
        alphaCutoff: Float = this.alphaCutoff,
        sides: Sides = this.sides,
        shader: Shader? = this.shader,
        name: String = this.name,
        metallicRoughness: MetallicRoughness? = this.metallicRoughness,
        normalMap: NormalMap? = this.normalMap,
        occlusionMap: OcclusionMap? = this.occlusionMap,
        emissionMap: TextureMap? = this.emissionMap,
    ): Material = Material(
        baseColor, textureMap, shading, specular, shininess, emission, alphaMode, alphaCutoff, sides, shader, name,
        metallicRoughness, normalMap, occlusionMap, emissionMap,
    )

    override fun toString(): String {
        val look = if (isPhysical) "$metallicRoughness" else "$shading"
        return "Material(\"$name\", $baseColor, $look, texture=$texture)"
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

    /** Where on a surface light is evaluated. */
    public enum class Shading {
        /** No light: the base colour, the texture and the vertex colours only. */
        CONSTANT,

        /** Once for each face, with the normal of the face: facets are visible. */
        FLAT,

        /**
         * Once for each vertex, with the normal of the vertex; the resulting colours are interpolated (Gouraud 1971).
         */
        GOURAUD,

        /**
         * At every shaded sample, with the interpolated and renormalised normal; the highlight uses the reflected ray
         * (Phong 1975).
         */
        PHONG,

        /** As [PHONG], but the highlight uses the halfway vector (Blinn 1977). */
        BLINN_PHONG,
    }

    /**
     * A texture that changes the normals of a surface at each sample (contract rule 6.9). Immutable and thread safe.
     *
     * Red, green and blue are the components of a normal, from -1 (code 0) to 1 (code 255): along the tangent, along
     * the bitangent, and along the normal of the surface, as in glTF 2.0, section 3.9.3. The tangents of the surface
     * must belong to the texture coordinates of [map]. Where a surface has no tangents, its normals are not changed.
     *
     * @property map the texture, which should have [Texture.Encoding.LINEAR]
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

    /**
     * A texture that darkens indirect light, where a surface hides itself (contract rule 6.9). Immutable and thread
     * safe.
     *
     * Ambient light and light of the environment are multiplied by `1 + strength * (red - 1)`.
     *
     * @property map the texture, which should have [Texture.Encoding.LINEAR]; only its red component is used
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
}
