package dev.lazyz.scenes.gltf.materials

import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.ImageJson
import dev.lazyz.scenes.gltf.document.SamplerJson
import dev.lazyz.scenes.gltf.document.TextureJson
import dev.lazyz.scenes.images.ChannelPacking
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.world.material.Texture

/**
 * Textures (section 3.8): images in buffer views, data URIs and files, with their samplers. Each image is decoded once.
 *
 * The sampler's magnification filter is used; its minification filter is not, because all textures have mip levels. An
 * image that is missing or cannot be decoded gives a warning and no texture.
 */
internal class GltfTextures(private val document: GltfDocument) {
    /**
     * Decoded images by the location of their bytes, which several images may share: the number of a buffer view, or a
     * URI.
     */
    private val images = HashMap<Any, Texture?>()
    private val textures = HashMap<Pair<Int?, Texture.Encoding>, Texture?>()
    private val roughness = HashMap<Pair<Texture, Float>, Texture>()

    /**
     * Returns the texture with number [index], whose codes mean what [encoding] says. [where] is the place that refers
     * to it.
     */
    fun texture(index: Int?, encoding: Texture.Encoding, where: String): Texture? =
        textures.getOrPut(index to encoding) { read(index, where)?.withEncoding(encoding) }

    /** Returns a texture with green 1 - [factor] times the alpha of [glossiness], and blue 1. */
    fun roughness(glossiness: Texture, factor: Float): Texture = roughness.getOrPut(glossiness to factor) {
        document.source.loading.texels(document.source, glossiness.width.toLong() * glossiness.height)
        ChannelPacking.metallicRoughness(glossiness, null, { (255 - (it ushr 24) * factor + 0.5f).toInt() })!!
    }

    private fun read(index: Int?, where: String): Texture? {
        val texture = document.element(document.json.textures, index, "textures", where)
        val source = texture.source ?: other(texture)
        if (source == null) {
            document.warn("textures[$index]", " has no image of a known kind and is left out")
            return null
        }
        val image = document.element(document.json.images, source, "images", "textures[$index].source")
        val decoded = images.getOrPut(image.bufferView ?: image.uri ?: image) { decode(image, source) } ?: return null
        if (texture.sampler == null) return decoded
        val sampler = document.element(document.json.samplers, texture.sampler, "samplers", "textures[$index].sampler")
        val isNearest = sampler.magFilter == SamplerJson.NEAREST
        return decoded.withSampling(
            if (isNearest) Texture.Filter.NEAREST else Texture.Filter.BILINEAR,
            wrap(sampler.wrapS),
            wrap(sampler.wrapT),
        )
    }

    /** Returns the image in a format of an extension. */
    private fun other(texture: TextureJson): Int? =
        extensions.firstNotNullOfOrNull { (texture.extension(it)?.get("source") as? Number)?.toInt() }

    private fun wrap(wrap: Int?): Texture.Wrap = when (wrap) {
        SamplerJson.CLAMP_TO_EDGE -> Texture.Wrap.CLAMP
        SamplerJson.MIRRORED_REPEAT -> Texture.Wrap.MIRROR
        else -> Texture.Wrap.REPEAT
    }

    private fun decode(image: ImageJson, index: Int): Texture? {
        val uri = image.uri?.takeIf { image.bufferView == null && !document.isData(it) }
        val label = listOfNotNull("images[$index]", (uri ?: image.name)?.let { "($it)" }).joinToString(" ")
        if (uri != null) return file(uri, label)
        val bytes = bytes(image, index)
        if (bytes == null) {
            document.warn(label, " is missing and is left out")
            return null
        }
        val texture = TextureFiles.decode(document.source, bytes, image.name ?: "images[$index]")
        if (texture == null) document.warn(label, " ${TextureFiles.notDecoded(bytes)}")
        return texture
    }

    private fun file(uri: String, label: String): Texture? {
        val found = document.find(uri)
        if (found.file == null) {
            document.warn(label, " ${found.warning}")
            return null
        }
        val texture = TextureFiles.ofFile(document.source, found.file)
        if (texture == null) document.warn(label, " ${TextureFiles.notDecoded(found.file)}")
        return texture
    }

    /** Returns the bytes of an image that is stored in the model itself. */
    private fun bytes(image: ImageJson, index: Int): ByteArray? {
        if (image.bufferView == null) return image.uri?.let { document.data(it) }
        val view = document.view(image.bufferView, "images[$index].bufferView")
        return ByteArray(view.capacity()).also { view.get(it) }
    }

    companion object {
        /**
         * Extensions that refer to images in other formats. If a texture also has an image in a usual format, that one
         * is used; if not, that of the first of these, which may be in a format that is not read.
         */
        val extensions =
            listOf("EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds")
    }
}
