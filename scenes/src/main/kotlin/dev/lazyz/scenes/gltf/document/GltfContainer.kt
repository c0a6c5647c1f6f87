package dev.lazyz.scenes.gltf.document

import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonParser
import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.exc.StreamConstraintsException
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.gltf.version1.Version1Json
import dev.lazyz.scenes.json.JsonInput
import dev.lazyz.scenes.json.JsonMap
import dev.lazyz.scenes.json.JsonText
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TextEncoding
import java.io.ByteArrayInputStream
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Opens a glTF file in JSON or binary form and finds the JSON text and the binary chunk (section 4).
 */
internal object GltfContainer {
    private const val MAGIC = 0x46546C67
    private const val JSON_CHUNK = 0x4E4F534A
    private const val BINARY_CHUNK = 0x004E4942
    private const val HEADER = 12
    private const val CHUNK_HEADER = 8

    /** Bytes in which the first character is searched for. */
    private const val PROBE = 4096
    private const val COPY_AGAIN = "export or copy the model again"

    fun open(source: Source): GltfDocument {
        val buffer = ByteBuffer.wrap(source.bytes).order(ByteOrder.LITTLE_ENDIAN)
        val isBinary = source.bytes.size >= 4 && buffer.getInt(0) == MAGIC
        if (!isBinary) {
            if (!mayBeJson(source.bytes)) {
                val problem =
                    "the file is neither JSON, which begins with \"{\", nor binary, which begins with \"glTF\""
                source.fail("byte 0", problem, COPY_AGAIN)
            }
            return GltfDocument(source, GltfJson.read(source, 0, source.bytes.size), null)
        }

        // The header: magic number, version, total length
        if (source.bytes.size < HEADER) {
            source.fail("byte ${source.bytes.size}", "the file ends within its header of $HEADER bytes", COPY_AGAIN)
        }
        val version = buffer.getInt(4)
        if (version != 1 && version != 2) {
            source.fail("byte 4", "the version is $version, not 2", "export the model as glTF 2.0")
        }
        val length = buffer.getInt(8).toLong() and 0xFFFFFFFFL
        if (length > source.bytes.size) {
            val end = source.bytes.size
            source.fail("byte $end", "the file ends before the $length bytes that byte 8 announces", COPY_AGAIN)
        }
        if (version == 1) return version1(source, buffer, length.toInt())
        val text = chunk(source, buffer, HEADER, length)
        if (text.type != JSON_CHUNK) source.fail("byte $HEADER", "the first chunk is not JSON", COPY_AGAIN)
        val gltf = GltfJson.read(source, text.start, text.length)

        // Chunks after the second belong to extensions and are ignored
        val next = text.start + text.length
        val hasNext = next + CHUNK_HEADER <= length || isBinaryChunk(buffer, next)
        if (!hasNext) return GltfDocument(source, gltf, null)
        val binary = chunk(source, buffer, next, length).takeIf { it.type == BINARY_CHUNK }
        return GltfDocument(source, gltf, binary?.let { buffer.slice(it.start, it.length) })
    }

    /**
     * Reads a binary file of glTF 1.0. Its header has two more words, the length and the format of the JSON; the data
     * follows the JSON.
     */
    private fun version1(source: Source, buffer: ByteBuffer, length: Int): GltfDocument {
        val start = HEADER + CHUNK_HEADER
        val end = if (length < start) -1L else start + (buffer.getInt(HEADER).toLong() and 0xFFFFFFFFL)
        if (end !in start..length) {
            source.fail("byte $HEADER", "the JSON ends beyond the file of $length bytes", COPY_AGAIN)
        }
        val gltf = GltfJson.read(source, start, end.toInt() - start, GltfJson.Container.VERSION_1)
        return GltfDocument(source, gltf, buffer.slice(end.toInt(), length - end.toInt()))
    }

    /** Whether the first character of [bytes], after white space and zeros of UTF-16, is a bracket. */
    private fun mayBeJson(bytes: ByteArray): Boolean =
        TextEncoding.start(bytes, PROBE).firstOrNull { it > ' ' } in listOf('{', '[', null)

    private class Chunk(val type: Int, val start: Int, val length: Int)

    /** Whether a chunk of binary data begins at [at], also if that is beyond the length in the header. */
    private fun isBinaryChunk(buffer: ByteBuffer, at: Int): Boolean =
        at + CHUNK_HEADER <= buffer.capacity() && buffer.getInt(at + 4) == BINARY_CHUNK

    /** Returns the chunk that begins at [at] in a file whose header announces [total] bytes. */
    private fun chunk(source: Source, buffer: ByteBuffer, at: Int, total: Long): Chunk {
        val start = at + CHUNK_HEADER
        if (start > buffer.capacity()) source.fail("byte $at", "the file ends within the header of a chunk", COPY_AGAIN)
        val length = buffer.getInt(at).toLong() and 0xFFFFFFFFL
        if (start + length > buffer.capacity()) {
            source.fail("byte $at", "the file ends within this chunk of $length bytes", COPY_AGAIN)
        }
        if (start + length > total) {
            val problem = "the header announces a file of $total bytes, but the chunk at byte $at ends after " +
                "${start + length} bytes"
            source.fail("byte 8", problem, COPY_AGAIN)
        }
        return Chunk(buffer.getInt(at + 4), start, length.toInt())
    }
}

/** Reads the JSON of a glTF file into a [ModelJson]. Of equal keys in an object, the last counts. */
internal object GltfJson {
    private const val REMEDY = GltfObject.REMEDY

    /** The kind of file that contains the JSON. */
    enum class Container {
        /** A separate JSON file, or a binary file of version 2. */
        USUAL,

        /** A binary file of version 1. */
        VERSION_1,
    }

    fun read(source: Source, start: Int, length: Int, container: Container = Container.USUAL): ModelJson {
        val found = tree(source, start, length)
        val tree = if (Version1Json.isVersion1(found)) version2(source, found, container) else found
        val asset = tree.map("asset")
        val version = asset?.text("version").orEmpty()
        if (version.isEmpty()) source.fail("asset.version", "it is missing", "export the model as glTF 2.0")
        if (!version.startsWith("2.")) {
            source.fail("asset.version", "the version is \"$version\", not 2.0", "export the model as glTF 2.0")
        }
        val least = asset?.text("minVersion") ?: "2.0"
        if (!isSupported(least)) {
            val problem = "the file needs glTF \"$least\", and 2.0 is supported"
            source.fail("asset.minVersion", problem, "export the model as glTF 2.0")
        }
        val warnings = CountedWarnings(source)
        SpecularGlossiness.convert(tree, warnings)
        return ModelJson(GltfObject(warnings, "", tree)).also { warnings.report() }
    }

    /** Whether [version] does not ask for more than 2.0. */
    private fun isSupported(version: String): Boolean {
        val minor = version.substringAfter('.', "")
        if (minor.isEmpty() || !minor.all { it in '0'..'9' }) return false
        return when (version.substringBefore('.')) {
            "0", "1" -> true
            "2" -> minor.all { it == '0' }
            else -> false
        }
    }

    private fun version2(source: Source, tree: JsonMap, container: Container): JsonMap {
        source.warn("the file is glTF 1.0; its shaders, skins and animations are passed over: convert it to glTF 2.0")
        if (container == Container.VERSION_1) Version1Json.referToData(tree)
        return Version1Json.convert(source, tree) { where, problem -> source.fail(where, problem, REMEDY) }
    }

    private fun tree(source: Source, start: Int, length: Int): JsonMap {
        val what = if (start == 0) "this is no JSON" else "the JSON of the binary file is damaged"
        val bytes = ByteArrayInputStream(source.bytes, start, withoutPadding(source, start, length))
        val tree = try {
            JsonInput.parser(source, bytes, JsonFactory::createParser).use { parser ->
                if (parser.nextToken() == null) return@use null
                JsonText.value(parser, parser::getNumberValue) {}.also { requireEnd(source, parser) }
            }
        } catch (e: SceneFormatException) {
            throw e
        } catch (e: JsonProcessingException) {
            if (e is StreamConstraintsException && "nesting depth" in e.originalMessage) {
                val most = source.loading.limits.nesting
                source.fail(null, "the JSON is nested more than $most deep", Loading.NESTING_REMEDY, e)
            }
            source.fail(e.location?.let(JsonInput::place), "$what: ${brief(e.originalMessage)}", REMEDY, e)
        } catch (e: IOException) {
            source.fail(null, "$what: ${brief(e.message)}", REMEDY, e)
        }
        return tree as? JsonMap ?: source.fail(null, "the file holds no JSON object", "check what kind of file it is")
    }

    /** Some exporters pad the JSON of a GLB file with zeros, although the specification asks for spaces. */
    private fun withoutPadding(source: Source, start: Int, length: Int): Int {
        var size = length
        while (size > 0 && source.bytes[start + size - 1] == 0.toByte()) size--
        return size
    }

    /** Fails if there is text after the value that [parser] has read. */
    private fun requireEnd(source: Source, parser: JsonParser) {
        val end = try {
            parser.nextToken() == null
        } catch (_: JsonProcessingException) {
            false
        }
        if (end) return
        source.fail(JsonInput.place(parser.currentLocation()), "there is more text after the JSON object", REMEDY)
    }

    /** Shortens one of Jackson's messages, which may quote much of the file and end in references in brackets. */
    private fun brief(message: String?): String {
        val line = message.orEmpty().trim().lineSequence().first()
        return line.substringBefore(" (start marker").substringBefore(" (for ").take(MAX_MESSAGE)
    }

    private const val MAX_MESSAGE = 200
}
