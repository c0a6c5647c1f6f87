package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.scenes.gltf.document.AccessorJson
import dev.lazyz.scenes.gltf.document.ComponentType
import dev.lazyz.scenes.gltf.document.ElementType
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.PrimitiveJson
import dev.lazyz.scenes.gltf.draco.DracoException
import dev.lazyz.scenes.gltf.draco.DracoGeometry

/**
 * The attributes and vertex numbers of one primitive, read from accessors or decoded from `KHR_draco_mesh_compression`.
 */
internal class GltfVertices(
    private val document: GltfDocument,
    private val accessors: GltfAccessors,
    private val primitive: PrimitiveJson,
    private val where: String,
) {
    private val attributes = primitive.attributes
    private val draco = primitive.extension(DRACO)
    private val dracoIds = (draco?.get("attributes") as? Map<*, *>).orEmpty()
    private val dracoWhere = "$where.extensions.$DRACO"
    private val geometry: DracoGeometry? by lazy { draco?.let(::decode) }

    /**
     * Returns an attribute's numbers, vertex by vertex, or null if there is no such attribute. With [areFractions],
     * integers are fractions even if the accessor does not say that they are normalized.
     */
    fun floats(name: String, vararg types: ElementType, areFractions: Boolean = false): FloatArray? {
        val index = attributes[name] ?: return null
        val here = "$where.attributes.$name"
        val id = dracoIds[name] as? Int
        val decoded = (if (id == null) null else geometry)
            ?: return accessors.floats(index, here, *types, areFractions = areFractions)
        val isFraction = areFractions || accessor(name).normalized == true
        val numbers = decoding { decoded.floats(checkNotNull(id), isFraction) }
        if (numbers == null || types.none { it.numComponents * decoded.vertexCount == numbers.size }) {
            document.fail("$dracoWhere.attributes.$name", "the compressed data has no attribute $id of this kind")
        }
        return numbers
    }

    /**
     * Returns red, green, blue and alpha of [count] vertices, or null if they have no colours. Integers are fractions,
     * as the specification demands; some programs forget to say that they are.
     */
    fun colors(count: Int): FloatArray? {
        val numbers = floats(COLORS, ElementType.VEC3, ElementType.VEC4, areFractions = true) ?: return null
        val accessor = accessor(COLORS)
        if (accessor.normalized != true && accessor.componentType != ComponentType.FLOAT) {
            document.count("colours of integers that are not marked as normalized are read as if they were")
        }
        val elements = geometry?.takeIf { COLORS in dracoIds }?.vertexCount ?: accessor.count ?: 0
        val width = if (elements > 0) numbers.size / elements else 4
        checkCount(numbers, width, count, "$where.attributes.$COLORS")
        if (width == 4) return numbers
        return FloatArray(4 * count) { if (it % 4 == 3) 1f else numbers[it / 4 * 3 + it % 4] }
    }

    private fun accessor(attribute: String): AccessorJson = document.element(
        document.json.accessors, attributes[attribute], "accessors", "$where.attributes.$attribute",
    )

    /**
     * Returns the vertex numbers, or null if vertices are used in their order. A number that needs more than 31 bits is
     * negative.
     */
    fun indices(): IntArray? = geometry?.triangles ?: primitive.indices?.let { accessors.indices(it, "$where.indices") }

    /** Fails if [numbers], [width] for each vertex, are not for [count] vertices. */
    fun checkCount(numbers: FloatArray?, width: Int, count: Int, where: String) {
        if (numbers != null && numbers.size != width * count) {
            document.fail(where, "there are ${numbers.size / width} elements for $count positions")
        }
    }

    /** Counts the unused sets of colours and texture coordinates. [texCoords] are the sets that are used. */
    fun countUnused(texCoords: List<String>) {
        for (name in attributes.keys) {
            if (name.endsWith("_0") || name in texCoords) continue
            if (name.startsWith("TEXCOORD_")) document.count("further sets of texture coordinates are passed over")
            if (name.startsWith("COLOR_")) document.count("further sets of colours are passed over")
        }
    }

    private fun decode(json: Map<*, *>): DracoGeometry {
        val view = json["bufferView"] as? Int
        val bytes = document.view(view, "$dracoWhere.bufferView")
        val array = ByteArray(bytes.capacity()).also { bytes.get(it) }
        return decoding {
            val loading = document.source.loading
            DracoGeometry.decode(array, loading.millisecondsLeft, document.source::step) {
                loading.decode(document.source, it)
            }
        }
    }

    private fun <T> decoding(step: () -> T): T = try {
        step()
    } catch (e: DracoException) {
        document.source.fail(dracoWhere, "${e.message}", "export the model again, or without this compression", e)
    }

    companion object {
        const val DRACO = "KHR_draco_mesh_compression"
        private const val COLORS = "COLOR_0"
    }
}
