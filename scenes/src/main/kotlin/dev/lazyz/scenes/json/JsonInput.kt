package dev.lazyz.scenes.json

import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonLocation
import com.fasterxml.jackson.core.JsonParser
import com.fasterxml.jackson.core.JsonToken
import com.fasterxml.jackson.core.StreamReadConstraints
import com.fasterxml.jackson.core.util.JsonParserDelegate
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines
import java.io.FilterInputStream
import java.io.InputStream

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
