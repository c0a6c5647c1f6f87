package dev.lazyz.scenes.scenefile

import dev.lazyz.Rgba
import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.json.JsonWriter
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform

/** Assigns a name to every material of a scene, and writes the materials. */
internal class MaterialWriter(materials: Iterable<Material>) {
    /** Equal materials share a name. The default material has no name and is not written. */
    private val names = LinkedHashMap<Look, String>()
    private val byName = LinkedHashMap<String, Material>()
    private val plain = Look(Material())

    init {
        for (material in materials) {
            val look = Look(material)
            if (look == plain || look in names) continue
            val name = free(material.name)
            names[look] = name
            byName[name] = material
        }
    }

    val isEmpty: Boolean get() = byName.isEmpty()

    /** Returns the name of [material] in the file, or null if it is the default material. */
    fun name(material: Material): String? = names[Look(material)]

    fun write(out: JsonWriter) = out.members {
        for ((name, material) in byName) {
            key(name)
            write(this, material, name)
        }
    }

    private fun write(out: JsonWriter, material: Material, name: String) = out.members {
        val plain = plain.material
        if (material.name != name) key("name").text(material.name)
        if (material.baseColor != plain.baseColor) key("baseColor").color(material.baseColor)
        material.textureMap?.let { TextureMapWriter.write(key("texture"), it, Texture.Encoding.SRGB) }
        if (material.shading != plain.shading) key("shading").text(SceneFileNames.of(material.shading))
        material.shader?.let { key("tint").integer((it as Tint).number) }
        if (material.specular != plain.specular) key("specular").color(material.specular)
        if (material.shininess != plain.shininess) key("shininess").integer(material.shininess)
        if (material.emission != plain.emission) key("emission").color(material.emission)
        val usual = SceneFileNames.usualAlphaMode(material.metallicRoughness)
        if (material.alphaMode != usual) key("alphaMode").text(SceneFileNames.of(material.alphaMode))
        if (material.alphaCutoff != plain.alphaCutoff) key("alphaCutoff").float(material.alphaCutoff)
        if (material.sides != plain.sides) key("sides").text(SceneFileNames.of(material.sides))
        maps(this, material)
    }

    private fun maps(out: JsonWriter, material: Material) = with(out) {
        material.metallicRoughness?.let { model ->
            key("metallicRoughness").members {
                key("metallic").float(model.metallic)
                key("roughness").float(model.roughness)
                model.map?.let { TextureMapWriter.write(key("map"), it, Texture.Encoding.LINEAR) }
                model.lobes?.let { LobesWriter.write(this, it) }
            }
        }
        material.normalMap?.let { normalMap(it) }
        material.occlusionMap?.let { occlusion ->
            key("occlusionMap").members {
                key("strength").float(occlusion.strength)
                TextureMapWriter.write(key("map"), occlusion.map, Texture.Encoding.LINEAR)
            }
        }
        material.emissionMap?.let { TextureMapWriter.write(key("emissionMap"), it, Texture.Encoding.SRGB) }
    }

    /** Returns [wish] if it is not empty and not in use, otherwise a new name. */
    private fun free(wish: String): String {
        if (wish.isNotEmpty() && wish !in byName) return wish
        return generateSequence(byName.size + 1) { it + 1 }.map { "material-$it" }.first { it !in byName }
    }

    /** Compares materials by their properties, but textures, which can be large, by identity. */
    private class Look(val material: Material) {
        private val parts = material.run {
            listOf(
                baseColor, textureMap, shading, specular, shininess, emission, alphaMode, alphaCutoff, sides, shader,
                name, metallicRoughness, normalMap, occlusionMap, emissionMap,
            )
        }

        override fun equals(other: Any?): Boolean = other is Look && parts == other.parts

        override fun hashCode(): Int = parts.hashCode()

        override fun toString(): String = material.toString()
    }
}

/** Writes a normal map with its key. */
internal fun JsonWriter.normalMap(normals: NormalMap) = key("normalMap").members {
    key("scale").float(normals.scale)
    TextureMapWriter.write(key("map"), normals.map, Texture.Encoding.LINEAR)
}

/** Writes the lobes of a material, each as an object with all its numbers, colours and maps. */
internal object LobesWriter {
    fun write(out: JsonWriter, lobes: Lobes) = with(out) {
        lobes.specular?.run {
            key("specular").members {
                key("strength").float(strength)
                key("color").color(color)
                key("refraction").float(refraction)
                strengthMap?.let { numbers("strengthMap", it) }
                colorMap?.let { colors("colorMap", it) }
            }
        }
        lobes.sheen?.run {
            key("sheen").members {
                key("color").color(color)
                key("roughness").float(roughness)
                colorMap?.let { colors("colorMap", it) }
                roughnessMap?.let { numbers("roughnessMap", it) }
            }
        }
        lobes.clearcoat?.run {
            key("clearcoat").members {
                key("strength").float(strength)
                key("roughness").float(roughness)
                strengthMap?.let { numbers("strengthMap", it) }
                roughnessMap?.let { numbers("roughnessMap", it) }
                normalMap?.let { normalMap(it) }
            }
        }
        lobes.transmission?.run {
            key("transmission").members {
                key("strength").float(strength)
                strengthMap?.let { numbers("strengthMap", it) }
                key("thickness").float(thickness)
                thicknessMap?.let { numbers("thicknessMap", it) }
                key("attenuationColor").color(attenuationColor)
                if (attenuationDistance.isFinite()) key("attenuationDistance").float(attenuationDistance)
            }
        }
        lobes.iridescence?.run {
            key("iridescence").members {
                key("strength").float(strength)
                key("refraction").float(refraction)
                key("thickness").float(thickness)
                key("leastThickness").float(leastThickness)
                strengthMap?.let { numbers("strengthMap", it) }
                thicknessMap?.let { numbers("thicknessMap", it) }
            }
        }
        lobes.anisotropy?.run {
            key("anisotropy").members {
                key("strength").float(strength)
                key("rotation").float(rotation)
                map?.let { numbers("map", it) }
            }
        }
    }

    private fun JsonWriter.numbers(name: String, map: TextureMap) =
        TextureMapWriter.write(key(name), map, Texture.Encoding.LINEAR)

    private fun JsonWriter.colors(name: String, map: TextureMap) =
        TextureMapWriter.write(key(name), map, Texture.Encoding.SRGB)
}

/** Writes a colour in linear light. Alpha is omitted if it is 1. */
internal fun JsonWriter.color(color: Rgba) {
    if (color.alpha == 1f) {
        floats(color.red, color.green, color.blue)
    } else {
        floats(color.red, color.green, color.blue, color.alpha)
    }
}

/** Writes textures and how they are laid on surfaces. */
internal object TextureMapWriter {
    /** Writes [map]. [plain] is the meaning of the codes that need not be written. */
    fun write(out: JsonWriter, map: TextureMap, plain: Texture.Encoding) = out.members {
        val texture = map.texture
        if (texture.name.isNotEmpty()) key("name").text(texture.name)
        if (texture.filter != Texture.Filter.BILINEAR) key("filter").text(SceneFileNames.of(texture.filter))
        if (texture.mipFilter != MipFilter.ANISOTROPIC) key("mipFilter").text(SceneFileNames.of(texture.mipFilter))
        if (texture.wrapU != Texture.Wrap.REPEAT || texture.wrapV != Texture.Wrap.REPEAT) {
            val wraps = listOf(texture.wrapU, texture.wrapV)
            key("wrap").inline(2) { text(SceneFileNames.of(wraps[it])) }
        }
        if (texture.encoding != plain) key("encoding").text(SceneFileNames.of(texture.encoding))
        if (map.uvSet != 0) key("uvSet").integer(map.uvSet)
        if (map.transform != UvTransform.IDENTITY) transform(key("transform"), map.transform)
        key("image").text(EmbeddedImage.write(texture))
    }

    private fun transform(out: JsonWriter, transform: UvTransform) = out.members {
        key("scale").doubles(transform.scaleU, transform.scaleV)
        key("rotation").double(transform.rotation)
        key("offset").doubles(transform.offsetU, transform.offsetV)
    }
}
