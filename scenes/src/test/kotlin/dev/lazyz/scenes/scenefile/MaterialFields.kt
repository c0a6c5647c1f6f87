package dev.lazyz.scenes.scenefile

import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.TextureMap

/** All that a material is made of, to compare. */
internal object MaterialFields {
    fun of(material: Material): List<Any?> = material.run {
        listOf(baseColor, shading, specular, shininess, emission, alphaMode, alphaCutoff, sides, name, shader) +
            map(textureMap) + map(emissionMap) +
            listOf(metallicRoughness?.metallic, metallicRoughness?.roughness, map(metallicRoughness?.map)) +
            lobes(metallicRoughness?.lobes) +
            listOf(normalMap?.scale, map(normalMap?.map), occlusionMap?.strength, map(occlusionMap?.map))
    }

    private fun lobes(lobes: Lobes?): List<Any?> = listOf(
        lobes?.specular?.run { listOf(strength, color, refraction, map(strengthMap), map(colorMap)) },
        lobes?.sheen?.run { listOf(color, roughness, map(colorMap), map(roughnessMap)) },
        lobes?.clearcoat?.run {
            listOf(strength, roughness, map(strengthMap), map(roughnessMap), normalMap?.scale, map(normalMap?.map))
        },
        lobes?.transmission?.run {
            listOf(
                strength, map(strengthMap), thickness, map(thicknessMap), attenuationColor, attenuationDistance,
            )
        },
        lobes?.iridescence?.run {
            listOf(strength, refraction, thickness, leastThickness, map(strengthMap), map(thicknessMap))
        },
        lobes?.anisotropy?.run { listOf(strength, rotation, map(map)) },
    )

    private fun map(map: TextureMap?): List<Any?>? = map?.texture?.run {
        val texels = List(width * height) { texel(it % width, it / width) }
        listOf(width, height, filter, wrapU, wrapV, name, mipFilter, encoding, texels, map.uvSet, map.transform)
    }
}
