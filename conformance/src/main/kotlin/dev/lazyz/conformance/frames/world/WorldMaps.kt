package dev.lazyz.conformance.frames.world

import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.NormalMap
import dev.lazyz.world.material.OcclusionMap
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

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
        .combine(oneOf(0f, 1f, 0.5f), oneOf(0.5f, 1f, 0.25f, 0f), maybe(2, 1, WorldTextures.numbers()))
        .`as` { metallic, roughness, maps ->
            val map = maps.firstOrNull()
            val words = listOfNotNull(code(metallic), code(roughness), map?.code)
            MaterialChange(
                { it.withMetallicRoughness(MetallicRoughness(metallic, roughness, map?.value)) },
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
