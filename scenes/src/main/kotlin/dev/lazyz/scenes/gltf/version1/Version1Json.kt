package dev.lazyz.scenes.gltf.version1

import dev.lazyz.Rgba
import dev.lazyz.scenes.json.JsonList
import dev.lazyz.scenes.json.JsonMap
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
    private val old: JsonMap,
    private val fail: (String, String) -> Nothing,
) {
    private val new = JsonMap()
    private val names = HashMap<String, Map<String, Int>>()
    private val extraNodes = ArrayList<JsonMap>()
    private val colorless = HashMap<String, Boolean>()

    private fun convert(): JsonMap {
        new["asset"] = JsonMap().also { it["version"] = "2.0" }
        listOf("buffers", "bufferViews", "accessors", "images", "samplers", "textures", "materials").forEach(::number)
        listOf("meshes", "cameras", "nodes", "scenes").forEach(::number)
        changeAll("buffers")
        changeAll("bufferViews") { where, view -> refer(view, "buffer", "buffers", where) }
        changeAll("accessors", ::accessor)
        changeAll("images", ::image)
        changeAll("samplers")
        changeAll("textures") { where, texture ->
            refer(texture, "source", "images", where)
            refer(texture, "sampler", "samplers", where)
        }
        val materials = Version1Materials(old, names.getValue("textures"))
        for (name in names.getValue("materials").keys) {
            source.step()
            list("materials").add(materials.convert(old.map("materials")?.map(name) ?: JsonMap()))
        }
        changeAll("meshes", ::mesh)
        changeAll("cameras")
        changeAll("nodes", ::node)
        list("nodes").addAll(extraNodes)
        changeAll("scenes") { where, scene -> refer(scene, "nodes", "nodes", where) }
        old["scene"]?.let { new["scene"] = index(it, "scenes", "scene") }
        old.map("extensions")?.get(RTC)?.let { rtc -> new["extensions"] = JsonMap().also { it[RTC] = rtc } }
        return new
    }

    /** Numbers the objects of a list. The data of a binary file comes first, as version 2.0 requires. */
    private fun number(list: String) {
        val all = old.map(list).orEmpty()
        val numbers = LinkedHashMap<String, Int>()
        if (BINARY in all) numbers[BINARY] = 0
        for (name in all.keys) {
            source.step()
            numbers.putIfAbsent(name, numbers.size)
        }
        names[list] = numbers
    }

    private fun list(name: String): JsonList = new.list(name) ?: JsonList().also { new[name] = it }

    /** Moves the objects called [name] to their list, after [change]. */
    private fun changeAll(name: String, change: (String, JsonMap) -> Unit = { _, _ -> }) {
        for (key in names.getValue(name).keys) {
            source.step()
            val where = "$name.$key"
            val element = old.map(name)?.map(key) ?: fail(where, "it is no JSON object")
            change(where, element)
            list(name).add(element)
        }
    }

    /** Replaces the name or the list of names at [key] with numbers. */
    private fun refer(owner: JsonMap, key: String, list: String, where: String) {
        val value = owner[key] ?: return
        if (value is JsonList) {
            for (i in value.indices) value[i] = index(value[i], list, "$where.$key[$i]")
        } else {
            owner[key] = index(value, list, "$where.$key")
        }
    }

    private fun index(name: Any?, list: String, where: String): Int {
        source.step()
        val text = name.takeUnless { it is JsonMap || it is JsonList } ?: ""
        return names.getValue(list)["$text"] ?: fail(where, "$list.$text does not exist")
    }

    /** Converts an accessor. In version 2.0 the stride is a property of the buffer view. */
    private fun accessor(where: String, accessor: JsonMap) {
        refer(accessor, "bufferView", "bufferViews", where)
        val stride = accessor.remove("byteStride")?.takeIf { ((it as? Number)?.toInt() ?: 0) != 0 } ?: return
        val views = list("bufferViews")
        val view = views.getOrNull(accessor["bufferView"] as? Int ?: -1) as? JsonMap ?: return
        accessor["bufferView"] = views.size
        views.add(JsonMap().also { it += view }.also { it["byteStride"] = stride })
    }

    private fun image(where: String, image: JsonMap) {
        val binary = (image.remove("extensions") as? JsonMap)?.map("KHR_binary_glTF") ?: return
        refer(binary, "bufferView", "bufferViews", where)
        image.remove("uri")
        binary["bufferView"]?.let { image["bufferView"] = it }
    }

    private fun mesh(where: String, mesh: JsonMap) {
        for ((i, primitive) in mesh.list("primitives").orEmpty().withIndex()) {
            source.step()
            val here = "$where.primitives[$i]"
            if (primitive !is JsonMap) fail(here, "it is no JSON object")
            val isColorless = isColorless(old.map("materials")?.map("${primitive["material"]}")?.text("technique"))
            refer(primitive, "indices", "accessors", here)
            refer(primitive, "material", "materials", here)
            val attributes = primitive.map("attributes") ?: continue
            for (name in attributes.keys.toList()) {
                source.step()
                refer(attributes, name, "accessors", "$here.attributes")
                if (isColorless && name.startsWith(COLOR)) attributes.remove(name)
                if (name in unnumbered && name in attributes) attributes["${name}_0"] = attributes.remove(name)
            }
        }
    }

    /** Whether the shader of a technique reads attributes, but no colours of vertices. */
    private fun isColorless(technique: String?): Boolean = technique != null && colorless.getOrPut(technique) {
        val parameters = old.map("techniques")?.map(technique)?.map("parameters").orEmpty().values
        val read = parameters.mapNotNull { (it as? JsonMap)?.text("semantic") }
        "POSITION" in read && read.none { it.startsWith(COLOR) }
    }

    /** Converts a node. A node of version 2.0 has one mesh; additional meshes go to new child nodes. */
    private fun node(where: String, node: JsonMap) {
        for (key in listOf("skin", "skeletons", "jointName")) node.remove(key)
        refer(node, "children", "nodes", where)
        refer(node, "camera", "cameras", where)
        refer(node, "meshes", "meshes", where)
        val meshes = node.remove("meshes") as? JsonList ?: return
        for ((i, mesh) in meshes.withIndex()) {
            if (i == 0) {
                node["mesh"] = mesh
            } else {
                val children = node.list("children") ?: JsonList().also { node["children"] = it }
                children.add(names.getValue("nodes").size + extraNodes.size)
                extraNodes.add(JsonMap().also { it["mesh"] = mesh })
            }
        }
    }

    companion object {
        /** The name of the buffer that holds the data of a binary file. */
        private const val BINARY = "binary_glTF"

        /** The extension that moves the whole model. */
        private const val RTC = "CESIUM_RTC"

        private const val COLOR = "COLOR"

        private val unnumbered = setOf(COLOR, "TEXCOORD")

        /** Whether [tree] is of version 1.0, or has no version number but the structure of version 1.0. */
        fun isVersion1(tree: JsonMap): Boolean {
            val version = tree.map("asset")?.text("version").orEmpty()
            val isInForm = listOf("meshes", "accessors", "techniques").any { tree.map(it) != null }
            return version == "1" || version.startsWith("1.") || (version.isEmpty() && isInForm)
        }

        /**
         * Makes the buffer named `binary_glTF` refer to the data of the binary file that contains [tree]. Its URI is
         * ignored.
         */
        fun referToData(tree: JsonMap) {
            tree.map("buffers")?.map(BINARY)?.remove("uri")
        }

        /**
         * Returns equivalent JSON of version 2.0 for the [tree] of [source], whose parts it takes over.
         *
         * @param fail called with a place in the file and the problem there
         */
        fun convert(source: Source, tree: JsonMap, fail: (String, String) -> Nothing): JsonMap =
            Version1Json(source, tree, fail).convert()
    }
}

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
