package dev.lazyz.conformance.frames.world

import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.scenes.Tint
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/**
 * Generates materials: every shading, highlights, emission, masks, one and two sides; and what [WorldMaps] adds, for
 * example textures.
 */
internal object WorldMaterials {
    /** Colours whose components are multiples of 1/8, mostly opaque. */
    val colors: Arbitrary<Rgba> = Combinators
        .combine(ints(0, 0x1FF), oneOf(1f, 1f, 1f, 1f, 0.5f, 0.5f, 0.75f, 0.25f, 0f))
        .`as` { bits, alpha -> Rgba((bits and 7) / 8f, (bits shr 3 and 7) / 8f, (bits shr 6) / 8f, alpha) }

    /** Generates materials that do not blend. Some have a mask. */
    fun opaque(): Arbitrary<Coded<Material>> =
        materials(mixed(8 to Arbitraries.just(AlphaMode.OPAQUE), 1 to Arbitraries.just(AlphaMode.MASK)))

    /** Generates materials most of which blend. */
    fun blended(): Arbitrary<Coded<Material>> =
        materials(mixed(6 to Arbitraries.just(AlphaMode.BLEND), 2 to oneOf(AlphaMode.OPAQUE, AlphaMode.MASK)))

    /**
     * Generates materials that are lit with the normals of the vertices and visible from both sides. Some have a normal
     * map.
     */
    fun twoSided(): Arbitrary<Coded<Material>> = Combinators
        .combine(
            colors, oneOf(Shading.PHONG, Shading.BLINN_PHONG, Shading.GOURAUD), highlights(), WorldMaps.onlyNormals(),
        )
        .`as` { color, shading, highlight, normals ->
            coded(Look(color, shading, highlight, Rgba.BLACK), Cut(), normals)
        }

    private fun materials(modes: Arbitrary<AlphaMode>): Arbitrary<Coded<Material>> {
        val emissions = mixed(3 to Arbitraries.just(Rgba.BLACK), 1 to colors.map { it.scaled(0.25f) })
        val shadings = oneOf(Shading.PHONG, Shading.BLINN_PHONG, Shading.GOURAUD, Shading.CONSTANT, Shading.FLAT)
        val looks = Combinators.combine(colors, shadings, highlights(), emissions).`as`(::Look)
        val sides = mixed(11 to Arbitraries.just(Sides.BOTH), 1 to Arbitraries.just(Sides.FRONT))
        val cuts = Combinators.combine(modes, oneOf(0.5f, 0.25f, 128 / 255f), sides).`as`(::Cut)
        return Combinators.combine(looks, cuts, WorldMaps.any()).`as`(::coded)
    }

    /** Generates no highlight, or an exponent and a colour. */
    private fun highlights(): Arbitrary<Highlight> = mixed(
        2 to Arbitraries.just(Highlight(Rgba.BLACK, 32)),
        3 to Combinators.combine(colors, oneOf(1, 2, 5, 32, 1024)).`as`(::Highlight),
    )

    private class Highlight(val color: Rgba, val shininess: Int)

    private class Look(val color: Rgba, val shading: Shading, val highlight: Highlight, val emission: Rgba,)

    private class Cut(val mode: AlphaMode = AlphaMode.OPAQUE, val cutoff: Float = 0.5f, val sides: Sides = Sides.BOTH,)

    private fun coded(look: Look, cut: Cut, changes: List<MaterialChange>): Coded<Material> {
        val highlight = look.highlight
        val words = listOfNotNull(
            code(look.color),
            "shading = Shading.${look.shading}",
            "specular = ${code(highlight.color)}, shininess = ${highlight.shininess}"
                .takeIf { highlight.color != Rgba.BLACK },
            "emission = ${code(look.emission)}".takeIf { look.emission != Rgba.BLACK },
            "alphaMode = AlphaMode.${cut.mode}".takeIf { cut.mode != AlphaMode.OPAQUE },
            "alphaCutoff = ${code(cut.cutoff)}".takeIf { cut.mode == AlphaMode.MASK },
            "sides = Sides.${cut.sides}".takeIf { cut.sides != Sides.BOTH },
        )
        val cutoff = if (cut.mode == AlphaMode.MASK) cut.cutoff else 0.5f
        val plain = Material(
            look.color, null, look.shading, highlight.color, highlight.shininess, look.emission, cut.mode, cutoff,
            cut.sides,
        )
        return Coded(
            changes.fold(plain) { material, change -> change.value(material) },
            words.joinToString(prefix = "Material(", postfix = ")") + changes.joinToString("") { it.code },
        )
    }
}

/** A change of a material. Its code is a call of a member function of the material. */
internal typealias MaterialChange = Coded<(Material) -> Material>

/** Generates what materials have besides colours: maps of all kinds, and metallic-roughness models. */
internal object WorldMaps {
    /** Generates any maps, and sometimes a metallic-roughness model. Shrinks to nothing. */
    fun any(): Arbitrary<List<MaterialChange>> =
        Combinators.combine(maybe(1, 2, textures()), maybe(5, 1, models()), details())
            .`as` { texture, model, details -> texture + model + details }

    /** Generates a normal map with a probability of one third. */
    fun onlyNormals(): Arbitrary<List<MaterialChange>> = maybe(2, 1, normals())

    /** Generates maps that few materials have, each with a small probability. */
    private fun details(): Arbitrary<List<MaterialChange>> =
        Combinators.combine(maybe(5, 1, normals()), maybe(9, 1, occlusions()), maybe(9, 1, emissions()))
            .`as` { normals, occlusion, emission -> normals + occlusion + emission }

    private fun textures() = WorldTextures.colors().map { map ->
        MaterialChange({ it.withTextureMap(map.value) }, ".withTextureMap(${map.code})")
    }

    private fun models(): Arbitrary<MaterialChange> = Combinators
        .combine(
            oneOf(0f, 1f, 0.5f), oneOf(0.5f, 1f, 0.25f, 0f), maybe(2, 1, WorldTextures.numbers()),
            maybe(1, 1, WorldLobes.any()),
        )
        .`as` { metallic, roughness, maps, manyLobes ->
            val map = maps.firstOrNull()
            val lobes = manyLobes.firstOrNull()
            val words = listOfNotNull(
                code(metallic), code(roughness), map?.code, lobes?.let { "lobes = ${it.code}" },
            )
            MaterialChange(
                { it.withMetallicRoughness(MetallicRoughness(metallic, roughness, map?.value, lobes?.value)) },
                ".withMetallicRoughness(MetallicRoughness(${words.joinToString()}))",
            )
        }

    private fun normals(): Arbitrary<MaterialChange> =
        Combinators.combine(WorldTextures.normals(), oneOf(1f, 0.5f, -2f)).`as` { map, scale ->
            MaterialChange(
                { it.withNormalMap(NormalMap(map.value, scale)) },
                ".withNormalMap(NormalMap(${map.code}, ${code(scale)}))",
            )
        }

    private fun occlusions(): Arbitrary<MaterialChange> =
        Combinators.combine(WorldTextures.numbers(), oneOf(1f, 0.5f)).`as` { map, strength ->
            MaterialChange(
                { it.withOcclusionMap(OcclusionMap(map.value, strength)) },
                ".withOcclusionMap(OcclusionMap(${map.code}, ${code(strength)}))",
            )
        }

    private fun emissions(): Arbitrary<MaterialChange> = WorldTextures.colors().map { map ->
        val light = Rgba(0.5f, 0.25f, 0.75f)
        MaterialChange(
            { it.withEmission(light).withEmissionMap(map.value) },
            ".withEmission(${code(light)}).withEmissionMap(${map.code})",
        )
    }

    /** Generates no element or one, with these weights. */
    private fun <T : Any> maybe(none: Int, one: Int, elements: Arbitrary<T>): Arbitrary<List<T>> =
        mixed(none to Arbitraries.just(listOf<T>()), one to elements.map { listOf(it) })
}

/** Generates lobes without maps. */
internal object WorldLobes {
    private val strengths = oneOf(1f, 0.5f, 0f)
    private val roughness = oneOf(0.5f, 1f, 0.25f, 0f)
    private val indices = oneOf(1.5f, 1f, 2.5f, 0f)

    /** Generates any lobes. Shrinks to none. */
    fun any(): Arbitrary<Coded<Lobes>> = Combinators.combine(
        orNone(speculars()), orNone(sheens()), orNone(clearcoats()), orNone(transmissions()), orNone(films()),
        orNone(stretches()),
    ).`as` { specular, sheen, clearcoat, transmission, film, stretch ->
        val words = listOf(specular, sheen, clearcoat, transmission, film, stretch).map { it.code }
        Coded(
            Lobes(specular.value, sheen.value, clearcoat.value, transmission.value, film.value, stretch.value),
            words.joinToString(", ", "Lobes(", ")"),
        )
    }

    private fun speculars() =
        Combinators.combine(strengths, WorldMaterials.colors, indices).`as` { strength, color, index ->
            Coded(Lobes.Specular(strength, color, index), "Specular(${code(strength)}, ${code(color)}, ${code(index)})")
        }

    private fun sheens() = Combinators.combine(WorldMaterials.colors, roughness).`as` { color, roughness ->
        Coded(Lobes.Sheen(color, roughness), "Sheen(${code(color)}, ${code(roughness)})")
    }

    private fun clearcoats() = Combinators.combine(strengths, roughness).`as` { strength, roughness ->
        Coded(Lobes.Clearcoat(strength, roughness), "Clearcoat(${code(strength)}, ${code(roughness)})")
    }

    private fun transmissions() =
        Combinators.combine(strengths, oneOf(0f, 1f), WorldMaterials.colors).`as` { strength, thickness, color ->
            Coded(
                Lobes.Transmission(strength, null, thickness, null, color, 2f),
                "Transmission(${code(strength)}, null, ${code(thickness)}, null, ${code(color)}, 2f)",
            )
        }

    private fun films() = Combinators.combine(strengths, oneOf(400f, 0f, 250f)).`as` { strength, thickness ->
        Coded(
            Lobes.Iridescence(strength, 1.5f, thickness),
            "Iridescence(${code(strength)}, 1.5f, ${code(thickness)})",
        )
    }

    private fun stretches() = Combinators.combine(strengths, oneOf(0f, 30f, -75f)).`as` { strength, rotation ->
        Coded(Lobes.Anisotropy(strength, rotation), "Anisotropy(${code(strength)}, ${code(rotation)})")
    }

    private fun <T : Any> orNone(lobes: Arbitrary<Coded<T>>): Arbitrary<Coded<T?>> = mixed(
        1 to Arbitraries.just(Coded<T?>(null, "null")),
        1 to lobes.map { Coded<T?>(it.value, "Lobes.${it.code}") },
    )
}

/** Generates small textures with every filter, and how they are laid on surfaces. */
internal object WorldTextures {
    /** Generates textures of any colours. Half of them are opaque. */
    fun colors(): Arbitrary<Coded<TextureMap>> = maps(Texture.Encoding.SRGB, Texture.Encoding.LINEAR, 0)

    /** Generates textures of any numbers. */
    fun numbers(): Arbitrary<Coded<TextureMap>> = maps(Texture.Encoding.LINEAR, Texture.Encoding.SRGB, 0)

    /** Generates textures of normals, whose blue is at least half: they point outward. */
    fun normals(): Arbitrary<Coded<TextureMap>> = maps(Texture.Encoding.LINEAR, Texture.Encoding.SRGB, 0x80)

    /**
     * Generates textures with the encoding [usual], sometimes [other], whose texels have at least the bits [least].
     * Some have a mip filter, some use the second texture coordinates, some transform the coordinates.
     */
    private fun maps(usual: Texture.Encoding, other: Texture.Encoding, least: Int): Arbitrary<Coded<TextureMap>> =
        Combinators.combine(textures(usual, other, least), oneOf(0, 0, 0, 1), transforms())
            .`as` { texture, uvSet, transform ->
                val words = listOfNotNull(
                    texture.code,
                    "$uvSet".takeIf { uvSet != 0 || transform != UvTransform.IDENTITY },
                    code(transform).takeIf { transform != UvTransform.IDENTITY },
                )
                Coded(TextureMap(texture.value, uvSet, transform), words.joinToString(", ", "TextureMap(", ")"))
            }

    /** Generates transforms: mostly none, otherwise larger and smaller ones, rotated, mirrored and moved. */
    private fun transforms(): Arbitrary<UvTransform> = mixed(
        3 to Arbitraries.just(UvTransform.IDENTITY),
        1 to oneOf(
            UvTransform(offsetU = 0.5, offsetV = 0.25),
            UvTransform(6.0, 6.0),
            UvTransform(0.5, 2.0, 30.0, 0.25, -0.5),
            UvTransform(-1.0, 1.0, 90.0, 1.0, 0.0),
        ),
    )

    private fun textures(usual: Texture.Encoding, other: Texture.Encoding, least: Int): Arbitrary<Coded<Texture>> {
        val sizes = oneOf(2 to 2, 1 to 1, 3 to 5, 1 to 4, 8 to 8)
        val wraps = oneOf(*Texture.Wrap.values())
        val mipFilters = oneOf(MipFilter.NONE, MipFilter.NONE, MipFilter.TRILINEAR, MipFilter.ANISOTROPIC)
        val encodings = oneOf(usual, usual, usual, usual, other)
        return Combinators
            .combine(sizes, ints(0, 0xFF), oneOf(*Texture.Filter.values()), wraps, wraps, mipFilters, encodings)
            .`as` { (width, height), seed, filter, wrapU, wrapV, mipFilter, encoding ->
                val texels = IntArray(width * height) { texel(seed, it) or least }
                val words = listOfNotNull(
                    "$width, $height, intArrayOf(${texels.joinToString()})",
                    "Texture.Filter.$filter, Texture.Wrap.$wrapU, Texture.Wrap.$wrapV",
                    "mipFilter = MipFilter.$mipFilter".takeIf { mipFilter != MipFilter.NONE },
                    "encoding = Texture.Encoding.$encoding".takeIf { encoding != Texture.Encoding.SRGB },
                )
                Coded(
                    Texture(width, height, texels, filter, wrapU, wrapV, mipFilter = mipFilter, encoding = encoding),
                    words.joinToString(", ", "Texture(", ")"),
                )
            }
    }

    /** Returns any colour. Half of all textures are opaque. */
    private fun texel(seed: Int, number: Int): Int {
        val bits = Tint.hash(seed, number, 0, 0)
        val alpha = if (seed % 2 == 0) 0xFF else ALPHAS[bits ushr 24 and 3]
        return alpha shl 24 or (bits and 0xFFFFFF)
    }

    private val ALPHAS = intArrayOf(0xFF, 0xFF, 0x80, 0)

    private fun code(it: UvTransform): String =
        "UvTransform(${it.scaleU}, ${it.scaleV}, ${it.rotation}, ${it.offsetU}, ${it.offsetV})"
}
