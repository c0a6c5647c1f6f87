package dev.lazyz.scenes.gltf.version1

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.node.ArrayNode
import com.fasterxml.jackson.databind.node.JsonNodeFactory
import com.fasterxml.jackson.databind.node.ObjectNode
import dev.lazyz.scenes.loading.Source

/**
 * Converts the JSON of glTF 1.0 to that of glTF 2.0 (Khronos Group, "glTF 1.0 Specification"). Objects that are
 * identified by names become lists, in the order of the file, and references to names become numbers.
 *
 * Meshes, nodes, cameras, textures and the diffuse colour of materials ([Version1Materials]) are kept. Shaders, skins
 * and animations are dropped, so meshes appear as stored.
 */
internal class Version1Json private constructor(
    private val source: Source,
    private val old: JsonNode,
    private val fail: (String, String) -> Nothing,
) {
    private val new = JsonNodeFactory.instance.objectNode()
    private val names = HashMap<String, Map<String, Int>>()
    private val extraNodes = ArrayList<ObjectNode>()

    private fun convert(): ObjectNode {
        new.putObject("asset").put("version", "2.0")
        listOf("buffers", "bufferViews", "accessors", "images", "samplers", "textures", "materials").forEach(::number)
        listOf("meshes", "cameras", "nodes", "scenes").forEach(::number)
        copies("buffers")
        copies("bufferViews") { where, view -> refer(view, "buffer", "buffers", where) }
        copies("accessors", ::accessor)
        copies("images", ::image)
        copies("samplers")
        copies("textures") { where, texture ->
            refer(texture, "source", "images", where)
            refer(texture, "sampler", "samplers", where)
        }
        val materials = Version1Materials(old, names.getValue("textures"))
        for (name in names.getValue("materials").keys) {
            source.step()
            list("materials").add(materials.convert(old.path("materials").path(name)))
        }
        copies("meshes", ::mesh)
        copies("cameras")
        copies("nodes", ::node)
        extraNodes.forEach { list("nodes").add(it) }
        copies("scenes") { where, scene -> refer(scene, "nodes", "nodes", where) }
        old["scene"]?.let { new.put("scene", index(it, "scenes", "scene")) }
        old.path("extensions")[RTC]?.let { new.putObject("extensions").set<JsonNode>(RTC, it) }
        return new
    }

    /** Numbers the objects of a list. The data of a binary file comes first, as version 2.0 requires. */
    private fun number(list: String) {
        val all = old.path(list)
        val numbers = LinkedHashMap<String, Int>()
        if (all.has(BINARY)) numbers[BINARY] = 0
        for (name in all.fieldNames()) {
            source.step()
            numbers.putIfAbsent(name, numbers.size)
        }
        names[list] = numbers
    }

    private fun list(name: String): ArrayNode = new.withArrayProperty(name)

    private fun copies(name: String, change: (String, ObjectNode) -> Unit = { _, _ -> }) {
        for (key in names.getValue(name).keys) {
            source.step()
            val where = "$name.$key"
            val copy = old.path(name).path(key).deepCopy<JsonNode>()
            if (copy !is ObjectNode) fail(where, "it is no JSON object")
            change(where, copy)
            list(name).add(copy)
        }
    }

    /** Replaces the name or the list of names at [key] with numbers. */
    private fun refer(owner: ObjectNode, key: String, list: String, where: String) {
        val value = owner[key] ?: return
        if (value is ArrayNode) {
            for (i in 0 until value.size()) value.set(i, index(value[i], list, "$where.$key[$i]"))
        } else {
            owner.put(key, index(value, list, "$where.$key"))
        }
    }

    private fun index(name: JsonNode, list: String, where: String): Int {
        source.step()
        return names.getValue(list)[name.asText()] ?: fail(where, "$list.${name.asText()} does not exist")
    }

    /** Converts an accessor. In version 2.0 the stride is a property of the buffer view. */
    private fun accessor(where: String, accessor: ObjectNode) {
        refer(accessor, "bufferView", "bufferViews", where)
        val stride = accessor.remove("byteStride")?.takeIf { it.asInt() != 0 } ?: return
        val views = list("bufferViews")
        val view = views[accessor.path("bufferView").asInt(-1)] as? ObjectNode ?: return
        accessor.put("bufferView", views.size())
        views.add(view.deepCopy().set<ObjectNode>("byteStride", stride))
    }

    private fun image(where: String, image: ObjectNode) {
        val binary = (image.remove("extensions") as? ObjectNode)?.get("KHR_binary_glTF") as? ObjectNode ?: return
        refer(binary, "bufferView", "bufferViews", where)
        image.remove("uri")
        binary["bufferView"]?.let { image.set<JsonNode>("bufferView", it) }
    }

    private fun mesh(where: String, mesh: ObjectNode) {
        for ((i, primitive) in mesh.path("primitives").withIndex()) {
            source.step()
            val here = "$where.primitives[$i]"
            if (primitive !is ObjectNode) fail(here, "it is no JSON object")
            refer(primitive, "indices", "accessors", here)
            refer(primitive, "material", "materials", here)
            val attributes = primitive["attributes"] as? ObjectNode ?: continue
            for (name in attributes.fieldNames().asSequence().toList()) {
                source.step()
                refer(attributes, name, "accessors", "$here.attributes")
                if (name !in unnumbered) continue
                attributes.set<JsonNode>("${name}_0", attributes.remove(name))
            }
        }
    }

    /** Converts a node. A node of version 2.0 has one mesh; additional meshes go to new child nodes. */
    private fun node(where: String, node: ObjectNode) {
        for (key in listOf("skin", "skeletons", "jointName")) node.remove(key)
        refer(node, "children", "nodes", where)
        refer(node, "camera", "cameras", where)
        refer(node, "meshes", "meshes", where)
        val meshes = node.remove("meshes") as? ArrayNode ?: return
        for ((i, mesh) in meshes.withIndex()) {
            if (i == 0) {
                node.set<JsonNode>("mesh", mesh)
            } else {
                node.withArrayProperty("children").add(names.getValue("nodes").size + extraNodes.size)
                extraNodes.add(JsonNodeFactory.instance.objectNode().set<ObjectNode>("mesh", mesh))
            }
        }
    }

    companion object {
        /** The name of the buffer that holds the data of a binary file. */
        private const val BINARY = "binary_glTF"

        /** The extension that moves the whole model. */
        private const val RTC = "CESIUM_RTC"

        private val unnumbered = setOf("COLOR", "TEXCOORD")

        /** Whether [tree] is of version 1.0, or has no version number but the structure of version 1.0. */
        fun isVersion1(tree: JsonNode): Boolean {
            val version = tree.path("asset").path("version").asText("")
            val isInForm = listOf("meshes", "accessors", "techniques").any { tree.path(it).isObject }
            return version == "1" || version.startsWith("1.") || (version.isEmpty() && isInForm)
        }

        /**
         * Makes the buffer named `binary_glTF` refer to the data of the binary file that contains [tree]. Its URI is
         * ignored.
         */
        fun referToData(tree: JsonNode) {
            (tree.path("buffers").path(BINARY) as? ObjectNode)?.remove("uri")
        }

        /**
         * Returns equivalent JSON of version 2.0 for the [tree] of [source].
         *
         * @param fail called with a place in the file and the problem there
         */
        fun convert(source: Source, tree: JsonNode, fail: (String, String) -> Nothing): ObjectNode =
            Version1Json(source, tree, fail).convert()
    }
}
