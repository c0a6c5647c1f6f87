package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.NormalMap
import dev.lazyz.world.material.OcclusionMap
import dev.lazyz.world.material.TextureEncoding

/** Reads materials and their maps. */
internal class MaterialReader(source: Source) {
    private val named = HashMap<String, Material>()
    private val textures = TextureMapReader(source)

    /** Reads the materials that surfaces can refer to by name. */
    fun readNamed(node: JsonNode) {
        for ((name, value) in node.named()) named[name] = material(value, name)
    }

    /** Reads a reference to a named material, or an inline material. */
    fun read(node: JsonNode): Material {
        if (!node.isText) return material(node, "")
        val name = node.text()
        return named[name] ?: node.fail(
            "there is no material \"$name\"",
            if (named.isEmpty()) "add it to \"materials\"" else "known: ${named.keys.sorted().joinToString()}",
        )
    }

    private fun material(node: JsonNode, name: String): Material {
        val members = node.members(
            "name", "baseColor", "texture", "shading", "specular", "shininess", "emission", "alphaMode", "alphaCutoff",
            "sides", "tint", "metallicRoughness", "normalMap", "occlusionMap", "emissionMap",
        )
        val plain = Material()
        return node.checked {
            Material(
                baseColor = members["baseColor"]?.let(ColorReader::read) ?: plain.baseColor,
                shading = members["shading"]?.choice(SceneFileNames.shadings) ?: plain.shading,
                specular = members["specular"]?.let(ColorReader::read) ?: plain.specular,
                shininess = members["shininess"]?.integer() ?: plain.shininess,
                emission = members["emission"]?.let(ColorReader::read) ?: plain.emission,
                alphaMode = members["alphaMode"]?.choice(SceneFileNames.alphaModes) ?: plain.alphaMode,
                alphaCutoff = members["alphaCutoff"]?.float() ?: plain.alphaCutoff,
                sides = members["sides"]?.choice(SceneFileNames.sides) ?: plain.sides,
                shader = members["tint"]?.integer()?.let(::Tint),
                name = members["name"]?.text() ?: name,
            ).withTextureMap(members["texture"]?.let { textures.read(it, TextureEncoding.SRGB) })
                .withMetallicRoughness(members["metallicRoughness"]?.let(::model))
                .withNormalMap(members["normalMap"]?.let(::normalMap))
                .withOcclusionMap(members["occlusionMap"]?.let(::occlusionMap))
                .withEmissionMap(members["emissionMap"]?.let { textures.read(it, TextureEncoding.SRGB) })
        }
    }

    private fun model(node: JsonNode): MetallicRoughness {
        val members = node.members("metallic", "roughness", "map")
        val plain = MetallicRoughness()
        val map = members["map"]?.let { textures.read(it, TextureEncoding.LINEAR) }
        return node.checked {
            MetallicRoughness(
                members["metallic"]?.float() ?: plain.metallic,
                members["roughness"]?.float() ?: plain.roughness,
                map,
            )
        }
    }

    private fun normalMap(node: JsonNode): NormalMap? {
        val members = node.members("map", "scale")
        val map = textures.read(members.required("map"), TextureEncoding.LINEAR) ?: return null
        return node.checked { NormalMap(map, members["scale"]?.float() ?: 1f) }
    }

    private fun occlusionMap(node: JsonNode): OcclusionMap? {
        val members = node.members("map", "strength")
        val map = textures.read(members.required("map"), TextureEncoding.LINEAR) ?: return null
        return node.checked { OcclusionMap(map, members["strength"]?.float() ?: 1f) }
    }
}
