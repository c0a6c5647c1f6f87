package dev.lazyz.scenes.gltf.document

import dev.lazyz.scenes.gltf.meshopt.MeshoptData
import dev.lazyz.scenes.gltf.meshopt.MeshoptException
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Decodes buffer views that are compressed with `EXT_meshopt_compression` or `KHR_meshopt_compression`. Each is decoded
 * once.
 */
internal class GltfCompressedViews(private val document: GltfDocument) {
    private val views = HashMap<Int, ByteBuffer>()

    /** Returns the decoded content of a compressed buffer view, or null if the view is not compressed. */
    fun view(view: BufferViewJson, index: Int): ByteBuffer? {
        val name = NAMES.firstOrNull { view.extension(it) != null } ?: return null
        val elements = views.getOrPut(index) {
            decode(view, index, checkNotNull(view.extension(name)), "bufferViews[$index].extensions.$name")
        }
        return elements.duplicate().order(ByteOrder.LITTLE_ENDIAN)
    }

    private fun decode(view: BufferViewJson, index: Int, json: Map<*, *>, where: String): ByteBuffer {
        val bytes = document.bytes(
            whole(json, "buffer", where, null),
            whole(json, "byteOffset", where, 0),
            whole(json, "byteLength", where, null),
            where,
        )
        try {
            val filter = json["filter"] as? String ?: "NONE"
            val count = whole(json, "count", where, null)
            val data = MeshoptData(json["mode"] as? String ?: "", filter, count, whole(json, "byteStride", where, null))

            // The view is read from the decoded data, so both must have the same length
            val size = data.count.toLong() * data.stride
            if (size != view.byteLength?.toLong()) {
                val problem = "it is ${view.byteLength}, but $size bytes are compressed"
                document.fail("bufferViews[$index].byteLength", problem)
            }
            document.source.loading.decode(document.source, size + bytes.capacity())
            return data.decode(ByteArray(bytes.capacity()).also { bytes.get(it) }, document.source::step)
        } catch (e: MeshoptException) {
            document.source.fail(where, e.message ?: "it is damaged", "export or compress the model again", e)
        }
    }

    private fun whole(json: Map<*, *>, name: String, where: String, missing: Int?): Int {
        val value = json[name] ?: return missing ?: document.fail("$where.$name", "it is missing")
        return value as? Int ?: document.fail("$where.$name", "$value is no whole number below 2147483648")
    }

    companion object {
        /** The extensions that compress buffer views. */
        val NAMES = listOf("KHR_meshopt_compression", "EXT_meshopt_compression")
    }
}
