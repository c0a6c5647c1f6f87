package dev.lazyz.scenes.scenefile

import dev.lazyz.world.Material

/** All that a material is made of, to compare. */
internal object MaterialFields {
    fun of(material: Material): List<Any?> = material.run {
        listOf(baseColor, shading, specular, shininess, emission, alphaMode, alphaCutoff, sides, name, shader) +
            texture?.run {
                val texels = List(width * height) { texel(it % width, it / width) }
                listOf(width, height, filter, wrapU, wrapV, name, texels)
            }
    }
}
