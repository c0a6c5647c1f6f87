package dev.lazyz.scenes.json

import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import java.nio.ByteBuffer
import java.nio.charset.CharacterCodingException
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement

/** Parses bytes to a JSON tree, and reports the place of every error. */
internal object JsonText {
    /**
     * A parser's message: offset, error, and the path, which is always the root. Versions of the parser that older
     * Kotlin compilers can read give the offset in no other way, and newer ones have the same message.
     */
    private val message =
        Regex("""(?:Unexpected JSON token at offset (\d+): )?(.*?)(?: at path: .*)?""", RegexOption.DOT_MATCHES_ALL)

    fun parse(source: Source): JsonElement {
        val text = decode(source)
        NestingCheck(source, text).run()
        try {
            return Json.parseToJsonElement(text)
        } catch (e: SerializationException) {
            val (offset, error) = message.matchEntire(e.message.orEmpty())!!.destructured
            source.fail(offset.toIntOrNull()?.let { place(text, it) }, "is not JSON: $error", cause = e)
        } catch (e: OutOfMemoryError) {
            source.exhausted("does not fit into memory", "keep meshes in files of their own, or raise -Xmx", e)
        }
    }

    /** Returns `line 3, column 7` for an offset in [text]. */
    fun place(text: String, offset: Int): String {
        val before = text.substring(0, offset.coerceIn(0, text.length))
        return "line ${before.count { it == '\n' } + 1}, column ${before.length - before.lastIndexOf('\n')}"
    }

    private fun decode(source: Source): String {
        val bytes = source.bytes
        val hasMark = bytes.size >= 3 && bytes[0] == 0xEF.toByte() && bytes[1] == 0xBB.toByte() &&
            bytes[2] == 0xBF.toByte()
        val start = if (hasMark) 3 else 0
        try {
            return Charsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes, start, bytes.size - start)).toString()
        } catch (e: CharacterCodingException) {
            source.fail(null, "is not text in UTF-8", "save it as UTF-8", e)
        } catch (e: OutOfMemoryError) {
            source.exhausted("does not fit into memory", "keep meshes in files of their own, or raise -Xmx", e)
        }
    }
}

/**
 * Checks a text for two errors that the parser does not report: nesting that is too deep for the parser's stack, and
 * a key that occurs twice in one object, of which the parser would keep the last.
 */
private class NestingCheck(private val source: Source, private val text: String) {
    /** Keys of the objects around the current position; null stands for a list. */
    private val around = ArrayList<HashSet<String>?>()

    fun run() {
        var i = 0
        while (i < text.length) {
            when (text[i]) {
                '{' -> open(HashSet(), i)
                '[' -> open(null, i)
                '}', ']' -> around.removeLastOrNull()
                '"' -> i = string(i)
            }
            i++
        }
    }

    private fun open(keys: HashSet<String>?, offset: Int) {
        val most = source.loading.limits.nesting
        if (around.size == most) {
            source.fail(JsonText.place(text, offset), "is nested more than $most deep", Loading.NESTING_REMEDY)
        }
        around.add(keys)
    }

    /** Skips the string that starts at [start] and returns its end. A string followed by a colon is a key. */
    private fun string(start: Int): Int {
        var end = start + 1
        while (end < text.length && text[end] != '"') end += if (text[end] == '\\') 2 else 1
        var next = end + 1
        while (next < text.length && text[next].isWhitespace()) next++
        if (next < text.length && text[next] == ':') {
            val key = text.substring(start + 1, end)
            if (around.lastOrNull()?.add(key) == false) {
                source.fail(JsonText.place(text, start), "key \"$key\" is given twice", "remove one")
            }
        }
        return end
    }
}
