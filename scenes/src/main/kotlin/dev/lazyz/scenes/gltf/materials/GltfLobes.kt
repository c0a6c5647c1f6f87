package dev.lazyz.scenes.gltf.materials

import dev.lazyz.Rgba
import dev.lazyz.scenes.gltf.document.ExtensionValues
import dev.lazyz.scenes.gltf.document.LobeExtensions.ANISOTROPY
import dev.lazyz.scenes.gltf.document.LobeExtensions.CLEARCOAT
import dev.lazyz.scenes.gltf.document.LobeExtensions.IRIDESCENCE
import dev.lazyz.scenes.gltf.document.LobeExtensions.REFRACTION
import dev.lazyz.scenes.gltf.document.LobeExtensions.SHEEN
import dev.lazyz.scenes.gltf.document.LobeExtensions.SPECULAR
import dev.lazyz.scenes.gltf.document.LobeExtensions.TRANSMISSION
import dev.lazyz.scenes.gltf.document.LobeExtensions.VOLUME
import dev.lazyz.scenes.gltf.document.MaterialJson
import dev.lazyz.scenes.gltf.document.SpecularGlossiness
import dev.lazyz.scenes.gltf.document.SpecularGlossiness.TEXTURE
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Texture.Encoding

/** Reads the extensions of a material that become [Lobes]; those that change nothing count as missing. */
internal class GltfLobes(private val json: MaterialJson, private val maps: GltfMaps, where: String) {
    private val here = "$where.extensions"

    /** Returns the lobes of the material, or null if it has none. */
    fun read(): Lobes? {
        val lobes = Lobes(specular(), sheen(), clearcoat(), transmission(), iridescence(), anisotropy())
        return lobes.takeIf { it != Lobes() }
    }

    private fun specular(): Lobes.Specular? {
        // A specular colour is a reflectance, without a part that the index of refraction decides
        val glossiness = json.glossiness
        if (glossiness != null) {
            val map = maps.map(glossiness.texture, Encoding.SRGB, "$here.${SpecularGlossiness.NAME}.$TEXTURE")
            return Lobes.Specular(1f, color(glossiness.specularFactor, Rgba.WHITE), 0f, null, map)
        }
        val json = json.specular
        val refraction = this.json.extension(REFRACTION)?.let { ExtensionValues.number(it, "ior", DEFAULT).toFloat() }
        val specular = Lobes.Specular(
            json?.factor ?: 1f,
            color(json?.colorFactor, Rgba.WHITE),
            refraction?.takeIf { it == 0f || it >= 1f } ?: DEFAULT.toFloat(),
            maps.map(json?.texture, Encoding.LINEAR, "$here.$SPECULAR.specularTexture"),
            maps.map(json?.colorTexture, Encoding.SRGB, "$here.$SPECULAR.specularColorTexture"),
        )
        return specular.takeIf { it != Lobes.Specular() }
    }

    private fun sheen(): Lobes.Sheen? {
        val json = json.sheen ?: return null
        val color = color(json.colorFactor, Rgba.BLACK)
        if (color == Rgba.BLACK) return null
        return Lobes.Sheen(
            color,
            json.roughnessFactor ?: 0f,
            maps.map(json.colorTexture, Encoding.SRGB, "$here.$SHEEN.sheenColorTexture"),
            maps.map(json.roughnessTexture, Encoding.LINEAR, "$here.$SHEEN.sheenRoughnessTexture"),
        )
    }

    private fun clearcoat(): Lobes.Clearcoat? {
        val json = json.clearcoat ?: return null
        val strength = json.factor ?: 0f
        if (strength == 0f) return null
        val normals = maps.map(json.normalTexture, Encoding.LINEAR, "$here.$CLEARCOAT.clearcoatNormalTexture")
        return Lobes.Clearcoat(
            strength,
            json.roughnessFactor ?: 0f,
            maps.map(json.texture, Encoding.LINEAR, "$here.$CLEARCOAT.clearcoatTexture"),
            maps.map(json.roughnessTexture, Encoding.LINEAR, "$here.$CLEARCOAT.clearcoatRoughnessTexture"),
            normals?.let { NormalMap(it, json.normalTexture?.scale?.takeIf { scale -> scale.isFinite() } ?: 1f) },
        )
    }

    private fun transmission(): Lobes.Transmission? {
        val json = json.transmission ?: return null
        val strength = json.factor ?: 0f
        if (strength == 0f) return null
        val volume = this.json.volume
        return Lobes.Transmission(
            strength,
            maps.map(json.texture, Encoding.LINEAR, "$here.$TRANSMISSION.transmissionTexture"),
            volume?.thicknessFactor?.takeIf { it.isFinite() } ?: 0f,
            maps.map(volume?.thicknessTexture, Encoding.LINEAR, "$here.$VOLUME.thicknessTexture"),
            color(volume?.attenuationColor, Rgba.WHITE),
            volume?.attenuationDistance ?: Float.POSITIVE_INFINITY,
        )
    }

    private fun iridescence(): Lobes.Iridescence? {
        val json = json.iridescence ?: return null
        val strength = json.factor ?: 0f
        if (strength == 0f) return null
        return Lobes.Iridescence(
            strength,
            json.refraction?.takeIf { it.isFinite() } ?: 1.3f,
            json.maximum?.takeIf { it.isFinite() } ?: 400f,
            json.minimum?.takeIf { it.isFinite() } ?: 100f,
            maps.map(json.texture, Encoding.LINEAR, "$here.$IRIDESCENCE.iridescenceTexture"),
            maps.map(json.thicknessTexture, Encoding.LINEAR, "$here.$IRIDESCENCE.iridescenceThicknessTexture"),
        )
    }

    private fun anisotropy(): Lobes.Anisotropy? {
        val json = json.anisotropy ?: return null
        val strength = json.strength ?: 0f
        if (strength == 0f) return null
        val degrees = (json.rotation ?: 0f) * (180.0 / StrictMath.PI)
        return Lobes.Anisotropy(
            strength,
            degrees.toFloat().takeIf { it.isFinite() } ?: 0f,
            maps.map(json.texture, Encoding.LINEAR, "$here.$ANISOTROPY.anisotropyTexture"),
        )
    }

    private fun color(factors: FloatArray?, missing: Rgba): Rgba {
        val (red, green, blue) = factors?.map { if (it > 0f && it.isFinite()) it else 0f } ?: return missing
        return Rgba(red, green, blue)
    }

    private companion object {
        const val DEFAULT = 1.5
    }
}
