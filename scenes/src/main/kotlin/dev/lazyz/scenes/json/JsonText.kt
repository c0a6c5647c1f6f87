package dev.lazyz.scenes.json

import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonLocation
import com.fasterxml.jackson.core.JsonParser
import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.JsonToken
import com.fasterxml.jackson.core.StreamReadConstraints
import com.fasterxml.jackson.core.exc.StreamConstraintsException
import com.fasterxml.jackson.core.util.JsonParserDelegate
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines
import java.io.ByteArrayInputStream
import java.io.FilterInputStream
import java.io.InputStream
import java.io.InputStreamReader
import java.nio.charset.CharacterCodingException

/** An object in a tree of JSON. */
internal class JsonMap : LinkedHashMap<String, Any?>() {
    /** Returns the object at [key], or null. */
    fun map(key: String): JsonMap? = this[key] as? JsonMap

    /** Returns the list at [key], or null. */
    fun list(key: String): JsonList? = this[key] as? JsonList

    /** Returns the text, number, true or false at [key] as text, or null. */
    fun text(key: String): String? = this[key].takeIf { it is String || it is Number || it is Boolean }?.toString()
}

/** A list in a tree of JSON. */
internal class JsonList : ArrayList<Any?>()

/** A number as the file writes it. */
internal class JsonNumber(val text: String) {
    override fun toString(): String = text
}

/** Parses a file to a tree: [JsonMap], [JsonList], texts, numbers, booleans and nulls. */
internal object JsonText {
    /**
     * Returns the only value in [source], in which numbers are [JsonNumber]. Reports the place of every error. A key
     * that occurs twice in one object is an error.
     */
    fun parse(source: Source): Any? {
        val bytes = ByteArrayInputStream(source.bytes).also { if (hasMark(source.bytes)) it.skip(MARK.size.toLong()) }
        try {
            val parser = JsonInput.parser(source, bytes) { factory, input ->
                factory.createParser(InputStreamReader(input, Charsets.UTF_8.newDecoder()))
            }
            return parser.use {
                if (it.nextToken() == null) source.fail(null, "is not JSON: there is no value", "begin it with {")
                val value = value(source, it)
                if (it.nextToken() != null) {
                    source.fail(place(it), "is not JSON: there is more text after its end", "remove it")
                }
                value
            }
        } catch (e: StreamConstraintsException) {
            val isDeep = "nesting depth" in e.originalMessage
            val problem = if (isDeep) "is nested more than ${source.loading.limits.nesting} deep" else message(e)
            source.fail(e.location?.let(JsonInput::place), problem, if (isDeep) Loading.NESTING_REMEDY else null, e)
        } catch (e: JsonProcessingException) {
            source.fail(e.location?.let(JsonInput::place), message(e), cause = e)
        } catch (e: CharacterCodingException) {
            source.fail(null, "is not text in UTF-8", "save it as UTF-8", e)
        } catch (e: OutOfMemoryError) {
            source.exhausted("does not fit into memory", "keep meshes in files of their own, or raise -Xmx", e)
        }
    }

    private fun message(e: JsonProcessingException): String =
        "is not JSON: ${e.originalMessage.lineSequence().first().substringBefore(" (start marker")}"

    private fun place(parser: JsonParser): String = JsonInput.place(parser.currentTokenLocation())

    private fun value(source: Source, parser: JsonParser): Any? = value(parser, { JsonNumber(parser.text) }) { key ->
        source.fail(place(parser), "key \"$key\" is given twice", "remove one")
    }

    /**
     * Returns the value at the current token of [parser].
     *
     * @param number returns the value of a number, which is the current token
     * @param repeated called with a key that its object has already; the last value stays
     */
    fun value(parser: JsonParser, number: () -> Any, repeated: (key: String) -> Unit): Any? =
        when (parser.currentToken()) {
            JsonToken.START_OBJECT -> {
                val members = JsonMap()
                while (parser.nextToken() == JsonToken.FIELD_NAME) {
                    val key = parser.currentName()
                    if (key in members) repeated(key)
                    parser.nextToken()
                    members[key] = value(parser, number, repeated)
                }
                members
            }
            JsonToken.START_ARRAY -> {
                val items = JsonList()
                while (parser.nextToken() != JsonToken.END_ARRAY) items.add(value(parser, number, repeated))
                items
            }
            JsonToken.VALUE_STRING -> parser.text
            JsonToken.VALUE_TRUE -> true
            JsonToken.VALUE_FALSE -> false
            JsonToken.VALUE_NULL -> null
            else -> number()
        }

    private fun hasMark(bytes: ByteArray): Boolean =
        bytes.size >= MARK.size && MARK.indices.all { bytes[it] == MARK[it] }

    /** The byte order mark of UTF-8. */
    private val MARK = byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte())
}

/** Opens JSON. Whatever is in it, each token and each piece of text is a step of work, see [Source.step]. */
internal object JsonInput {
    /** Returns a parser of [bytes], which [open] opens with a factory. Each object counts as an item. */
    fun parser(source: Source, bytes: InputStream, open: (JsonFactory, InputStream) -> JsonParser): JsonParser {
        val constraints = StreamReadConstraints.builder()
            .maxNestingDepth(source.loading.limits.nesting).maxStringLength(Int.MAX_VALUE).build()
        val factory = JsonFactory.builder().streamReadConstraints(constraints).build()
        return Counting(source, open(factory, SteppedBytes(source, bytes)))
    }

    /** Returns [location] as `line 3, column 7`. */
    fun place(location: JsonLocation): String = "line ${location.lineNr}, column ${location.columnNr}"

    private class Counting(private val source: Source, parser: JsonParser) : JsonParserDelegate(parser) {
        override fun nextToken(): JsonToken? {
            source.step()
            val token = super.nextToken()
            if (token == JsonToken.START_OBJECT) source.loading.items(source, 1)
            return token
        }
    }

    private class SteppedBytes(private val source: Source, bytes: InputStream) : FilterInputStream(bytes) {
        override fun read(into: ByteArray, offset: Int, length: Int): Int {
            source.step(length / TextLines.BYTES_A_STEP)
            return super.read(into, offset, length)
        }
    }
}
