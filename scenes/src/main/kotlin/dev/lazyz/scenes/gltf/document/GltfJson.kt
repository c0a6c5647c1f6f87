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
import java.io.ByteArrayInputStream
import java.io.IOException

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
