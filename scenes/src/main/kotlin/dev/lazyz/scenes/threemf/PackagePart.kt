package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers
import dev.lazyz.scenes.zip.ZipArchive
import java.io.BufferedInputStream
import java.io.FilterReader
import java.io.IOException
import java.io.InputStream
import java.io.InputStreamReader
import java.io.Reader
import javax.xml.stream.XMLInputFactory
import javax.xml.stream.XMLStreamConstants
import javax.xml.stream.XMLStreamException
import javax.xml.stream.XMLStreamReader

/**
 * Reads the elements of an XML part of a package in order. Document type definitions, custom entities and references to
 * other files are not supported. Namespaces of names are ignored. Not thread safe.
 *
 * @property path the part's name in the package
 */
internal class PackagePart(val source: Source, val path: String, input: InputStream) {
    private val text = guarded { XmlText.of(source, path, input) }
    private val reader: XMLStreamReader = guarded { factory.createXMLStreamReader(text) }
    private val names = HashSet<String>()

    /** Number of open elements. */
    var depth = 0
        private set

    /** The name of the current element. */
    val name: String get() = local(reader.localName)

    val attributeCount: Int get() = reader.attributeCount

    /** Calls [use] with the name of each child of the current element. Content that [use] does not read is skipped. */
    inline fun forEachChild(use: (String) -> Unit) {
        val inside = depth
        while (next(inside)) use(name)
    }

    /** Moves to the next child of the element at depth [inside]. Returns false after the last one. */
    fun next(inside: Int): Boolean {
        while (true) {
            source.step()
            when (guarded { reader.next() }) {
                XMLStreamConstants.START_ELEMENT -> {
                    depth++
                    checkElement()
                    if (depth == inside + 1) return true
                }
                XMLStreamConstants.END_ELEMENT -> if (--depth < inside) return false
                XMLStreamConstants.END_DOCUMENT -> return false
                XMLStreamConstants.PROCESSING_INSTRUCTION -> checkName(reader.piTarget)
                XMLStreamConstants.DTD -> fail("the part has a document type definition", "remove it")
            }
        }
    }

    fun attributeName(index: Int): String = local(reader.getAttributeLocalName(index))

    fun attribute(index: Int): String = reader.getAttributeValue(index)

    /** Returns the value of the attribute called [name], or null. */
    fun attribute(name: String): String? {
        for (i in 0 until attributeCount) if (attributeName(i) == name) return attribute(i)
        return null
    }

    /** Returns the words in the attribute called [name]; none if there is no such attribute. */
    fun words(name: String): List<String> {
        val text = attribute(name) ?: return emptyList()
        if (text.length > MOST_TEXT) fail("the attribute $name has more than $MOST_TEXT characters")
        source.step(text.length)
        return TextLines.words(text)
    }

    /** Returns the namespace that the current element declares for [prefix], or null if it declares none. */
    fun namespace(prefix: String): String? {
        for (i in 0 until attributeCount) {
            if (reader.getAttributePrefix(i) == "xmlns" && attributeName(i) == prefix) return attribute(i)
        }
        return null
    }

    /** Returns the integer, 0 or more, in the attribute called [name], or null if there is no such attribute. */
    fun number(name: String): Int? = attribute(name)?.let { whole(it) }

    /** Parses [value] as an integer, 0 or more. */
    fun whole(value: String): Int = value.trim().toIntOrNull()?.takeIf { it >= 0 }
        ?: fail("\"$value\" is not a whole number in 0..${Int.MAX_VALUE}")

    /** Parses [value] as a number. */
    fun float(value: String): Float = try {
        java.lang.Float.parseFloat(value)
    } catch (_: NumberFormatException) {
        fail("\"$value\" is not a number", TextNumbers.remedy(value) ?: "export the model again")
    }

    fun fail(problem: String, remedy: String = "export the model again", cause: Throwable? = null): Nothing =
        source.fail("$path, line ${reader.location.lineNumber}", problem, remedy, cause)

    fun close() {
        guarded { text.close() }
    }

    private fun checkElement() {
        if (depth > source.loading.limits.nesting) {
            fail("elements are nested more than ${source.loading.limits.nesting} deep", Loading.NESTING_REMEDY)
        }
        checkName(reader.localName)
        for (i in 0 until attributeCount) checkName(reader.getAttributeLocalName(i))
    }

    /** Limits the number of different names, because the parser keeps each of them in memory. */
    private fun checkName(name: String) {
        if (names.add(name) && names.size > MOST_NAMES) fail("the part has more than $MOST_NAMES different names")
    }

    private inline fun <T> guarded(read: () -> T): T = try {
        read()
    } catch (limit: SceneFormatException) {
        throw limit
    } catch (e: XMLStreamException) {
        // The parser wraps what the archive throws when the part exceeds a limit
        (e.nestedException as? SceneFormatException)?.let { throw it }
        val line = e.location?.lineNumber?.let { ", line $it" } ?: ""
        source.fail("$path$line", "is damaged: ${e.message?.substringAfter("Message: ")}", REMEDY, e)
    } catch (e: IOException) {
        source.fail(path, "is damaged: ${e.message}", REMEDY, e)
    } catch (e: RuntimeException) {
        source.fail(path, "is damaged: $e", REMEDY, e)
    }

    private companion object {
        const val MOST_NAMES = 10_000

        /** The longest list of numbers in an attribute, in characters. */
        const val MOST_TEXT = 1 shl 18
        const val REMEDY = "export or copy the model again"

        val factory: XMLInputFactory = XMLInputFactory.newDefaultFactory().apply {
            setProperty(XMLInputFactory.SUPPORT_DTD, false)
            setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false)

            // Some programs use prefixes that they do not declare
            setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false)
        }

        fun local(name: String): String {
            val colon = name.indexOf(':')
            return if (colon < 0) name else name.substring(colon + 1)
        }
    }
}

/**
 * The characters of an XML part, which is UTF-8 or UTF-16 (Open Packaging Conventions, 6.2.5). Invalid bytes become
 * U+FFFD. The length of a tag or text is limited, so that a parser cannot run out of memory.
 */
internal class XmlText private constructor(private val source: Source, private val path: String, reader: Reader) :
    FilterReader(reader) {
    /** Number of characters since the last `>`. */
    private var length = 0L

    override fun read(): Int = CharArray(1).let { if (read(it, 0, 1) < 0) -1 else it[0].code }

    override fun read(characters: CharArray, offset: Int, count: Int): Int {
        val read = super.read(characters, offset, count)
        var i = offset + read - 1
        while (i >= offset && characters[i] != '>') i--
        length = if (i >= offset) offset + read - 1L - i else length + maxOf(read, 0)
        if (length > MOST_LENGTH) {
            source.fail(path, "has a tag or text of more than $MOST_LENGTH characters", "export the model again")
        }
        return read
    }

    companion object {
        private const val MOST_LENGTH = 16L shl 20
        private const val LARGEST_MARK = 3

        /** Returns the characters of the part called [path], whose bytes are [input]. */
        fun of(source: Source, path: String, input: InputStream): XmlText {
            val bytes = BufferedInputStream(input)
            bytes.mark(LARGEST_MARK)
            val first = bytes.readNBytes(LARGEST_MARK)
            bytes.reset()
            return XmlText(source, path, reader(bytes, first))
        }

        private fun reader(bytes: InputStream, first: ByteArray): Reader = when {
            first.size < 2 -> InputStreamReader(bytes, Charsets.UTF_8)

            // A byte order mark, which is not part of the text, or a first character without one
            first[0] == 0xFE.toByte() || first[0] == 0xFF.toByte() -> InputStreamReader(bytes, Charsets.UTF_16)
            first[0] == 0.toByte() -> InputStreamReader(bytes, Charsets.UTF_16BE)
            first[1] == 0.toByte() -> InputStreamReader(bytes, Charsets.UTF_16LE)
            else -> InputStreamReader(bytes, Charsets.UTF_8).also { if (first[0] == 0xEF.toByte()) it.read() }
        }
    }
}

/**
 * The parts of a package, and the path of the main model part (3MF Consortium, "3D Manufacturing Format", version
 * 1.3.0, 2).
 */
internal class ThreeMfPackage(private val source: Source) {
    private val archive = ZipArchive(source)

    /** Name of the main model part. */
    val modelPath: String =
        target()?.removePrefix("/") ?: archive.names.firstOrNull { it.endsWith(".model", ignoreCase = true) }
            ?: source.fail(null, "the archive holds no 3D model", "check what kind of file it is")

    /** Opens the XML part called [path], or returns null if there is none. */
    fun part(path: String): PackagePart? = archive.open(path)?.let { PackagePart(source, path.removePrefix("/"), it) }

    /** Returns the content of the part called [path], or null if there is none or it is damaged. */
    fun bytes(path: String): ByteArray? = try {
        archive.open(path)?.use { it.readAllBytes() }
    } catch (limit: SceneFormatException) {
        throw limit
    } catch (_: IOException) {
        null
    }

    /**
     * Returns the name of the model part according to the package's relationships, or null if they name none, or one
     * that does not exist.
     */
    private fun target(): String? {
        val part = part(RELATIONSHIPS) ?: return null
        var target: String? = null
        part.forEachChild {
            part.forEachChild {
                if (target == null && part.attribute("Type") == MODEL_TYPE) target = part.attribute("Target")
            }
        }
        part.close()
        return target?.takeIf { path -> archive.names.any { it.equals(path.removePrefix("/"), ignoreCase = true) } }
    }

    private companion object {
        const val RELATIONSHIPS = "_rels/.rels"
        const val MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    }
}
