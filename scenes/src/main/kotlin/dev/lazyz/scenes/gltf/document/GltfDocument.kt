package dev.lazyz.scenes.gltf.document

import dev.lazyz.scenes.gltf.meshopt.MeshoptData
import dev.lazyz.scenes.gltf.meshopt.MeshoptException
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Source
import java.net.URLDecoder
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Base64

/**
 * An opened glTF file: its JSON, and the bytes that the JSON refers to. Not thread safe.
 *
 * @property source the file, for warnings, errors and the folder of referenced files
 * @property json the JSON; any value in it may be missing
 */
internal class GltfDocument(val source: Source, val json: ModelJson, private val binary: ByteBuffer?) {
    private val buffers = HashMap<Int, ByteBuffer>()
    private val compressed = GltfCompressedViews(this)
    private val counted = CountedWarnings(source)

    /**
     * Returns `list[index]`, or fails if it does not exist. [where] is the place that refers to it, and [name] the name
     * of the list.
     */
    fun <T : Any> element(list: List<T?>, index: Int?, name: String, where: String): T {
        val count = list.size
        if (index == null || index !in 0 until count) {
            fail(where, if (index == null) "it is missing" else "$name[$index] does not exist; there are $count")
        }
        return list[index] ?: fail("$name[$index]", "it is null")
    }

    /** Returns the bytes of a buffer view, little endian. [where] is the place that refers to it. */
    fun view(index: Int?, where: String): ByteBuffer {
        val view = element(json.bufferViews, index, "bufferViews", where)
        compressed.view(view, checkNotNull(index))?.let { return it }
        val here = "bufferViews[$index]"
        val length = view.byteLength ?: fail("$here.byteLength", "it is missing")
        return bytes(view.buffer, view.byteOffset ?: 0, length, here)
    }

    /** Returns bytes of a buffer, little endian. [here] is the place that refers to them. */
    fun bytes(index: Int?, offset: Int, length: Int, here: String): ByteBuffer {
        val buffer = buffer(index, "$here.buffer")
        if (offset < 0 || length < 0 || offset.toLong() + length > buffer.capacity()) {
            val end = offset.toLong() + length
            fail(here, "bytes $offset until $end are not within the buffer of ${buffer.capacity()}")
        }
        return buffer.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN)
    }

    private fun buffer(index: Int?, where: String): ByteBuffer {
        val buffer = element(json.buffers, index, "buffers", where)
        return buffers.getOrPut(checkNotNull(index)) {
            val here = "buffers[$index]"
            val uri = buffer.uri
            val bytes = when {
                uri != null -> ByteBuffer.wrap(resolve(uri, "$here.uri"))
                index == 0 && binary != null -> binary
                else -> fail("$here.uri", "it is missing, and there is no binary chunk")
            }
            val length = buffer.byteLength ?: bytes.capacity()
            if (length !in 0..bytes.capacity()) {
                fail("$here.byteLength", "it announces $length bytes, but there are ${bytes.capacity()}")
            }
            bytes.slice(0, length)
        }
    }

    private fun resolve(uri: String, where: String): ByteArray {
        if (isData(uri)) return data(uri) ?: fail(where, "the data URI is not in Base64")
        val found = find(uri)
        val file = found.file ?: source.fail(where, "the file $uri ${found.problem}", found.remedy)
        val bytes = FileReferences.read(file) ?: source.fail(where, "the file $uri cannot be read", "check permissions")
        source.loading.read(bytes.size)
        return bytes
    }

    /** Returns the file that [uri] refers to. Percent escapes such as `%20` are decoded. */
    fun find(uri: String): FileReferences.Found {
        val found = source.references.find(decoded(uri))
        return if (found.file != null) found else source.references.find(uri)
    }

    private fun decoded(uri: String): String = try {
        URLDecoder.decode(uri.replace("+", "%2B"), Charsets.UTF_8)
    } catch (_: IllegalArgumentException) {
        uri
    }

    /** Whether [uri] is a data URI, which contains its data. */
    fun isData(uri: String): Boolean = uri.startsWith("data:", ignoreCase = true)

    /** Returns the bytes of a data URI, or null if they are not in Base64. */
    fun data(uri: String): ByteArray? {
        val start = uri.indexOf(BASE64)
        if (start < 0) return null
        return try {
            Base64.getDecoder().decode(uri.substring(start + BASE64.length))
        } catch (_: IllegalArgumentException) {
            null
        }
    }

    /** Reports a warning, once for each [sentence]. */
    fun warn(sentence: String): Unit = source.warn(sentence)

    /** Reports the warning [subject] [after]; those that differ only in their [subject] become one. */
    fun warn(subject: String, after: String): Unit = source.warn("", subject, after)

    /** Adds [more] to the count of [sentence]. [warnOfCounts] reports the totals. */
    fun count(sentence: String, more: Int = 1): Unit = counted.count(sentence, more)

    /** Reports one warning for each sentence that was counted. */
    fun warnOfCounts(): Unit = counted.report()

    fun fail(where: String, problem: String): Nothing = source.fail(where, problem, "export the model again")

    private companion object {
        const val BASE64 = ";base64,"
    }
}

/** Warnings about the file [source], one for each kind, with how often it occurs. Not thread safe. */
internal class CountedWarnings(val source: Source) {
    private class Total(val example: String?) {
        var count = 0
    }

    private val totals = LinkedHashMap<String, Total>()

    /** Adds [more] to the count of [sentence]. The first [example] of a sentence is shown in brackets. */
    fun count(sentence: String, more: Int = 1, example: String? = null) {
        if (more > 0) totals.getOrPut(sentence) { Total(example) }.count += more
    }

    /** Reports one warning for each sentence that was counted. */
    fun report() {
        for ((sentence, total) in totals) {
            source.warn("$sentence: ${total.count}${total.example?.let { " ($it)" }.orEmpty()}")
        }
    }
}

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
