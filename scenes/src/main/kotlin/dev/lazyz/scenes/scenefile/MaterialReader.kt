package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Material
import dev.lazyz.world.MipFilter
import dev.lazyz.world.Texture
import dev.lazyz.world.TextureFilter
import dev.lazyz.world.TextureWrap

/** Reads materials and their textures. An image that several materials use is read once. */
internal class MaterialReader(private val source: Source) {
    private val named = HashMap<String, Material>()
    private val pictures = HashMap<String, Texture?>()

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
            "sides", "tint",
        )
        val plain = Material()
        return node.checked {
            Material(
                baseColor = members["baseColor"]?.let(ColorReader::read) ?: plain.baseColor,
                texture = members["texture"]?.let(::texture),
                shading = members["shading"]?.choice(SceneFileNames.shadings) ?: plain.shading,
                specular = members["specular"]?.let(ColorReader::read) ?: plain.specular,
                shininess = members["shininess"]?.integer() ?: plain.shininess,
                emission = members["emission"]?.let(ColorReader::read) ?: plain.emission,
                alphaMode = members["alphaMode"]?.choice(SceneFileNames.alphaModes) ?: plain.alphaMode,
                alphaCutoff = members["alphaCutoff"]?.float() ?: plain.alphaCutoff,
                sides = members["sides"]?.choice(SceneFileNames.sides) ?: plain.sides,
                shader = members["tint"]?.integer()?.let(::Tint),
                name = members["name"]?.text() ?: name,
            )
        }
    }

    private fun texture(node: JsonNode): Texture? {
        if (node.isText) return picture(node)
        val members = node.members("image", "filter", "mipFilter", "wrap", "name")
        val picture = picture(members.required("image")) ?: return null
        val filter = members["filter"]?.choice(SceneFileNames.filters) ?: TextureFilter.BILINEAR
        val mipFilter = members["mipFilter"]?.choice(SceneFileNames.mipFilters) ?: MipFilter.ANISOTROPIC
        val (wrapU, wrapV) = members["wrap"]?.let(::wraps) ?: (TextureWrap.REPEAT to TextureWrap.REPEAT)
        val name = members["name"]?.text() ?: picture.name
        return picture.withSampling(filter, wrapU, wrapV, mipFilter).withName(name)
    }

    private fun wraps(node: JsonNode): Pair<TextureWrap, TextureWrap> {
        if (node.isText) return node.choice(SceneFileNames.wraps).let { it to it }
        val items = node.items()
        if (items.size != 2) node.fail("needs 2 names, across and down, not ${items.size}")
        return items[0].choice(SceneFileNames.wraps) to items[1].choice(SceneFileNames.wraps)
    }

    /** Returns the image, or null with a warning if its file is missing or cannot be read. */
    private fun picture(node: JsonNode): Texture? {
        val reference = node.text()
        if (reference !in pictures) {
            val isEmbedded = EmbeddedImage.isEmbedded(reference)
            pictures[reference] =
                if (isEmbedded) EmbeddedImage.read(source, node) else TextureFiles.find(source, reference)
        }
        return pictures[reference]
    }
}
