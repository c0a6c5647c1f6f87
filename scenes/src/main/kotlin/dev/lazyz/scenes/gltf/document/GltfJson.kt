package dev.lazyz.scenes.gltf.document

import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonParser
import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.exc.StreamConstraintsException
import com.fasterxml.jackson.databind.DeserializationContext
import com.fasterxml.jackson.databind.JsonMappingException
import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.ObjectMapper
import com.fasterxml.jackson.databind.cfg.CoercionAction
import com.fasterxml.jackson.databind.cfg.CoercionInputShape
import com.fasterxml.jackson.databind.deser.std.StdDeserializer
import com.fasterxml.jackson.databind.module.SimpleModule
import com.fasterxml.jackson.databind.type.LogicalType
import de.javagl.jgltf.impl.v2.GlTF
import de.javagl.jgltf.model.io.JacksonUtils
import de.javagl.jgltf.model.io.JsonError
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.gltf.version1.Version1Json
import dev.lazyz.scenes.json.JsonInput
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import java.io.ByteArrayInputStream
import java.io.IOException

/**
 * Reads the JSON of a glTF file into jgltf's classes.
 *
 * A value of the wrong type is an error. A value of the right type that the specification does not allow, such as a
 * negative count, is ignored with a warning, because many files contain such values; factors outside their range are
 * clamped ([FactorRanges]). Unknown properties are allowed.
 */
internal object GltfJson {
    /** Created once, because it analyses jgltf's classes and caches the results. */
    private val mapper: ObjectMapper by lazy {
        JacksonUtils.createObjectMapper { error -> reading.get()?.let { report(it, error) } }.apply {
            // Text is no number
            for (type in listOf(LogicalType.Integer, LogicalType.Float, LogicalType.Boolean)) {
                for (shape in listOf(CoercionInputShape.String, CoercionInputShape.EmptyString)) {
                    coercionConfigFor(type).setCoercion(shape, CoercionAction.Fail)
                }
            }
            registerModule(SimpleModule().addDeserializer(Int::class.javaObjectType, WholeNumbers))
        }
    }

    /** Reads integers, also those with a fraction of 0, as 1.0; jgltf's classes have no others. */
    private object WholeNumbers : StdDeserializer<Int>(Int::class.javaObjectType) {
        private fun readResolve(): Any = WholeNumbers

        override fun deserialize(parser: JsonParser, context: DeserializationContext): Int {
            val number = if (parser.currentToken().isNumeric) parser.doubleValue else Double.NaN
            if (number.toInt().toDouble() == number) return number.toInt()
            return context.reportInputMismatch(this, "no whole number")
        }
    }

    /** The warnings about the file that the current thread is reading. */
    private val reading = ThreadLocal<CountedWarnings>()

    private const val REMEDY = "correct it or export the model again"

    /** The kind of file that contains the JSON. */
    enum class Container {
        /** A separate JSON file, or a binary file of version 2. */
        USUAL,

        /** A binary file of version 1. */
        VERSION_1,
    }

    fun read(source: Source, start: Int, length: Int, container: Container = Container.USUAL): GlTF {
        val found = tree(source, start, length)
        val tree = if (Version1Json.isVersion1(found)) version2(source, found, container) else found
        val version = tree.path("asset").path("version").asText("")
        if (version.isEmpty()) source.fail("asset.version", "it is missing", "export the model as glTF 2.0")
        if (!version.startsWith("2.")) {
            source.fail("asset.version", "the version is \"$version\", not 2.0", "export the model as glTF 2.0")
        }
        val least = tree.path("asset").path("minVersion").asText("2.0")
        if (!isSupported(least)) {
            val problem = "the file needs glTF \"$least\", and 2.0 is supported"
            source.fail("asset.minVersion", problem, "export the model as glTF 2.0")
        }
        val warnings = CountedWarnings(source)
        SpecularGlossiness.convert(tree, warnings)
        FactorRanges.clamp(tree, warnings)
        try {
            reading.set(warnings)
            val tokens = JsonInput.again(source, mapper.treeAsTokens(tree))
            return mapper.readValue(tokens, GlTF::class.java).also { warnings.report() }
        } catch (e: SceneFormatException) {
            throw e
        } catch (e: JsonMappingException) {
            generateSequence<Throwable>(e) { it.cause }.firstOrNull { it is SceneFormatException }?.let { throw it }
            source.fail(place(e), WrongTypes.problem(e, tree), REMEDY, e)
        } catch (e: IOException) {
            source.fail(null, "the JSON is not glTF: ${brief(e.message)}", REMEDY, e)
        } finally {
            reading.remove()
        }
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

    private fun version2(source: Source, tree: JsonNode, container: Container): JsonNode {
        source.warn("the file is glTF 1.0; its shaders, skins and animations are passed over: convert it to glTF 2.0")
        if (container == Container.VERSION_1) Version1Json.referToData(tree)
        return Version1Json.convert(source, tree) { where, problem -> source.fail(where, problem, REMEDY) }
    }

    private fun tree(source: Source, start: Int, length: Int): JsonNode {
        val what = if (start == 0) "this is no JSON" else "the JSON of the binary file is damaged"
        val bytes = ByteArrayInputStream(source.bytes, start, withoutPadding(source, start, length))
        val tree: JsonNode? = try {
            JsonInput.parser(source, bytes, JsonFactory::createParser).use { parser ->
                mapper.readTree<JsonNode?>(parser).also { requireEnd(source, parser) }
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
        if (tree?.isObject != true) source.fail(null, "the file holds no JSON object", "check what kind of file it is")
        return tree
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

    /**
     * Handles an error that jgltf reports: an unknown property, a value that a setter rejects, or a value of the wrong
     * type.
     */
    private fun report(warnings: CountedWarnings, error: JsonError) {
        val cause = error.throwable ?: return
        if (cause.cause !is IllegalArgumentException) throw cause
        val problem = cause.cause?.message.orEmpty()

        // Nothing is missing where a list is empty
        if (problem.endsWith("elements is < 1")) return
        val place = error.jsonPath.filter { it.isNotEmpty() }.joinToString(".")
        warnings.count("$place is passed over", example = brief(problem))
    }

    /** Returns the path to the value, for example `meshes[0].primitives[1].mode`. */
    private fun place(e: JsonMappingException): String =
        e.path.joinToString("") { if (it.fieldName == null) "[${it.index}]" else ".${it.fieldName}" }.removePrefix(".")

    /** Shortens one of Jackson's messages, which may quote much of the file and end in references in brackets. */
    private fun brief(message: String?): String {
        val line = message.orEmpty().trim().lineSequence().first()
        return line.substringBefore(" (start marker").substringBefore(" (for ").take(MAX_MESSAGE)
    }

    private const val MAX_MESSAGE = 200
}
