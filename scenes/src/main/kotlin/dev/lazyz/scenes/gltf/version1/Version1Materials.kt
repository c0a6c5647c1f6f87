package dev.lazyz.scenes.gltf.version1

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.node.JsonNodeFactory
import com.fasterxml.jackson.databind.node.ObjectNode
import dev.lazyz.Rgba

/**
 * Converts materials of glTF 1.0. Their shaders are arbitrary, so only the value named `diffuse` is used: a colour or a
 * texture, which becomes the base colour. Colours are sRGB-encoded, also those of the extension `KHR_materials_common`.
 *
 * @param textures numbers of textures by name
 */
internal class Version1Materials(private val file: JsonNode, private val textures: Map<String, Int>) {
    fun convert(old: JsonNode): ObjectNode {
        val new = JsonNodeFactory.instance.objectNode()
        old["name"]?.let { new.put("name", it.asText()) }
        val common = old.path("extensions").path("KHR_materials_common")
        val technique = file.path("techniques").path(old.path("technique").asText())
        val diffuse = listOf(
            common.path("values").path("diffuse"),
            old.path("values").path("diffuse"),
            technique.path("parameters").path("diffuse").path("value"),
        ).firstOrNull { !it.isMissingNode } ?: technique.path("diffuse")

        val pbr = new.putObject("pbrMetallicRoughness").put("metallicFactor", 0f)
        if (diffuse.isTextual) {
            textures[diffuse.asText()]?.let { pbr.putObject("baseColorTexture").put("index", it) }
        } else if (diffuse.size() >= 3) {
            val factor = pbr.putArray("baseColorFactor")
            for (i in 0 until 3) factor.add(Rgba.linearOf(diffuse[i].asDouble()))
            factor.add(diffuse.path(3).asDouble(1.0).coerceIn(0.0, 1.0).toFloat())
        }

        // Both sides are visible unless the technique or the extension specifies otherwise
        val enabled = technique.path("states").path("enable").map { it.asInt() }
        val isCulled = if (common.isMissingNode) CULL_FACE in enabled else !common.path("doubleSided").asBoolean()
        new.put("doubleSided", !isCulled)
        if (BLEND in enabled || common.path("transparent").asBoolean()) new.put("alphaMode", "BLEND")
        return new
    }

    private companion object {
        const val CULL_FACE = 2884
        const val BLEND = 3042
    }
}
