package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.json.JsonWriter
import dev.lazyz.world.material.MipFilter
import dev.lazyz.world.material.TextureEncoding
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureWrap
import dev.lazyz.world.material.UvTransform

/** Writes textures and how they are laid on surfaces. */
internal object TextureMapWriter {
    /** Writes [map]. [plain] is the meaning of the codes that need not be written. */
    fun write(out: JsonWriter, map: TextureMap, plain: TextureEncoding) = out.members {
        val texture = map.texture
        if (texture.name.isNotEmpty()) key("name").text(texture.name)
        if (texture.filter != TextureFilter.BILINEAR) key("filter").text(SceneFileNames.of(texture.filter))
        if (texture.mipFilter != MipFilter.ANISOTROPIC) key("mipFilter").text(SceneFileNames.of(texture.mipFilter))
        if (texture.wrapU != TextureWrap.REPEAT || texture.wrapV != TextureWrap.REPEAT) {
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
