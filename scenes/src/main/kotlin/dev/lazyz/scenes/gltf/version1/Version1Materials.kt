package dev.lazyz.scenes.gltf.version1

import dev.lazyz.Rgba
import dev.lazyz.scenes.json.JsonList
import dev.lazyz.scenes.json.JsonMap

/**
 * Converts materials of glTF 1.0. Their shaders are arbitrary, so only the value named `diffuse` is used: a colour or a
 * texture, which becomes the base colour. Colours are sRGB-encoded, also those of the extension `KHR_materials_common`.
 *
 * @param textures numbers of textures by name
 */
internal class Version1Materials(private val file: JsonMap, private val textures: Map<String, Int>) {
    fun convert(old: JsonMap): JsonMap {
        val new = JsonMap()
        old.text("name")?.let { new["name"] = it }
        val common = old.map("extensions")?.map("KHR_materials_common")
        val technique = file.map("techniques")?.map(old.text("technique").orEmpty())
        val diffuse = common?.map("values")?.get("diffuse")
            ?: old.map("values")?.get("diffuse")
            ?: technique?.map("parameters")?.map("diffuse")?.get("value")
            ?: technique?.get("diffuse")

        val pbr = JsonMap()
        new["pbrMetallicRoughness"] = pbr
        pbr["metallicFactor"] = 0
        if (diffuse is String) {
            textures[diffuse]?.let { texture -> pbr["baseColorTexture"] = JsonMap().also { it["index"] = texture } }
        } else if (diffuse is JsonList && diffuse.size >= 3) {
            val factor = JsonList()
            for (i in 0 until 3) factor.add(Rgba.linearOf(number(diffuse[i]) ?: 0.0))
            factor.add((number(diffuse.getOrNull(3)) ?: 1.0).coerceIn(0.0, 1.0))
            pbr["baseColorFactor"] = factor
        }

        // Both sides are visible unless the technique or the extension specifies otherwise
        val enabled = technique?.map("states")?.list("enable").orEmpty().map { number(it)?.toInt() }
        new["doubleSided"] = if (common == null) CULL_FACE !in enabled else common["doubleSided"] == true
        if (BLEND in enabled || common?.get("transparent") == true) new["alphaMode"] = "BLEND"
        return new
    }

    private fun number(json: Any?): Double? = (json as? Number)?.toDouble()

    private companion object {
        const val CULL_FACE = 2884
        const val BLEND = 3042
    }
}
