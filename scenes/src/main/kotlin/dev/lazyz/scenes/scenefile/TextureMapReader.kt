package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.MipFilter
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureEncoding
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureWrap
import dev.lazyz.world.material.UvTransform

/** Reads textures and how they are laid on surfaces. An image that several of them use is read once. */
internal class TextureMapReader(private val source: Source) {
    private val pictures = HashMap<String, Texture?>()

    /**
     * Returns the map that [node] describes: the name of a file, or an object. Null, with a warning, if its file is
     * missing or cannot be read.
     *
     * @param plain the meaning of the codes if the file does not say
     */
    fun read(node: JsonNode, plain: TextureEncoding): TextureMap? {
        if (node.isText) return picture(node)?.let { TextureMap(it.withEncoding(plain)) }
        val members = node.members("image", "filter", "mipFilter", "wrap", "name", "encoding", "uvSet", "transform")
        val picture = picture(members.required("image")) ?: return null
        val filter = members["filter"]?.choice(SceneFileNames.filters) ?: TextureFilter.BILINEAR
        val mipFilter = members["mipFilter"]?.choice(SceneFileNames.mipFilters) ?: MipFilter.ANISOTROPIC
        val (wrapU, wrapV) = members["wrap"]?.let(::wraps) ?: (TextureWrap.REPEAT to TextureWrap.REPEAT)
        val name = members["name"]?.text() ?: picture.name
        val encoding = members["encoding"]?.choice(SceneFileNames.encodings) ?: plain
        val texture = picture.withSampling(filter, wrapU, wrapV, mipFilter).withName(name).withEncoding(encoding)
        val transform = members["transform"]?.let(::transform) ?: UvTransform.IDENTITY
        return node.checked { TextureMap(texture, members["uvSet"]?.integer() ?: 0, transform) }
    }

    private fun transform(node: JsonNode): UvTransform {
        val members = node.members("scale", "rotation", "offset")
        val scale = members["scale"]?.doubles(2) ?: doubleArrayOf(1.0, 1.0)
        val offset = members["offset"]?.doubles(2) ?: doubleArrayOf(0.0, 0.0)
        val rotation = members["rotation"]?.double() ?: 0.0
        return node.checked { UvTransform(scale[0], scale[1], rotation, offset[0], offset[1]) }
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
