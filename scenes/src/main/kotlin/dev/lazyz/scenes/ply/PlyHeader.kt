package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines

/**
 * The types of numbers, each with two names.
 *
 * @property names the names used in headers: the C name first, then the one with the size in bits
 * @property size size in the binary forms, in bytes
 * @property most the number that stands for 1 in a colour of this type
 */
internal enum class PlyType(val names: List<String>, val size: Int, val most: Double) {
    CHAR(listOf("char", "int8"), 1, 127.0),
    UCHAR(listOf("uchar", "uint8"), 1, 255.0),
    SHORT(listOf("short", "int16"), 2, 32767.0),
    USHORT(listOf("ushort", "uint16"), 2, 65535.0),
    INT(listOf("int", "int32"), 4, 2147483647.0),
    UINT(listOf("uint", "uint32"), 4, 4294967295.0),
    FLOAT(listOf("float", "float32"), 4, 1.0),
    DOUBLE(listOf("double", "float64"), 8, 1.0),
    ;

    companion object {
        /** Returns the type called [name], or null. */
        fun of(name: String): PlyType? = entries.firstOrNull { name in it.names }
    }
}

/**
 * One column of an element: a number, or a list of numbers.
 *
 * @property name name of the column
 * @property type type of the number, or of each number in the list
 * @property countType type of the list's length, or null if the column is not a list
 */
internal class PlyProperty(val name: String, val type: PlyType, val countType: PlyType?) {
    /** Minimum size in the binary forms, in bytes. */
    val leastSize: Int get() = (countType ?: type).size
}

/**
 * A table of the body.
 *
 * @property name name of the rows, such as `vertex`
 * @property count number of rows
 * @property properties the columns
 */
internal class PlyElement(val name: String, val count: Int, val properties: List<PlyProperty>) {
    val hasLists: Boolean = properties.any { it.countType != null }

    /** The numbers of the columns that are numbers, and of those that are lists, by name; of equal names the first. */
    private val numbers = columns(isList = false)
    private val lists = columns(isList = true)

    private fun columns(isList: Boolean): Map<String, Int> {
        val columns = HashMap<String, Int>()
        for ((column, property) in properties.withIndex()) {
            if ((property.countType != null) == isList) columns.putIfAbsent(property.name, column)
        }
        return columns
    }

    /**
     * Returns the number of the first column whose name is in [names], or null. If [isList], searches only lists,
     * otherwise only numbers.
     */
    fun column(names: List<String>, isList: Boolean = false): Int? =
        names.mapNotNull { (if (isList) lists else numbers)[it] }.minOrNull()
}

/**
 * The forms of the body.
 *
 * @property id name in the header
 */
internal enum class PlyFormat(val id: String) {
    ASCII("ascii"),
    LITTLE_ENDIAN("binary_little_endian"),
    BIG_ENDIAN("binary_big_endian"),
}

/**
 * The content of the header.
 *
 * @property format form of the body
 * @property elements the body's tables, in order
 * @property bodyPosition position of the body's first byte
 * @property bodyLine number of the body's first line
 * @property textureFiles names of texture files, from comments that MeshLab writes
 */
internal class PlyHeader(
    val format: PlyFormat,
    val elements: List<PlyElement>,
    val bodyPosition: Long,
    val bodyLine: Int,
    val textureFiles: List<String>,
)

/** Reads a [PlyHeader]: lines of words up to `end_header`. */
internal class PlyHeaderReader(private val source: Source, private val lines: TextLines = TextLines(source)) {
    /** The elements so far by their names. */
    private val elements = LinkedHashMap<String, PlyElement>()
    private val properties = ArrayList<PlyProperty>()
    private var open: Pair<String, Int>? = null
    private var format: PlyFormat? = null
    private val textureFiles = ArrayList<String>()

    fun read(): PlyHeader {
        if (lines.next()?.trimEnd() != "ply") {
            source.fail("line 1", "a PLY file begins with the line \"ply\"", "check what kind of file it is")
        }
        val isMac = lines.bytes[lines.position - 1] == CARRIAGE_RETURN
        while (true) {
            val line = lines.next() ?: source.fail(
                "line ${lines.number}",
                "the file ends before end_header",
                "export or copy the model again",
            )
            val words = TextLines.words(line)
            when (words.firstOrNull()) {
                null, "obj_info" -> continue
                "comment" -> comment(words)
                "format" -> format(words)
                "element" -> element(words)
                "property" -> property(words)
                "end_header" -> return header(isMac)
                else -> fail("\"${words[0]}\" is not a keyword of PLY headers")
            }
        }
    }

    private fun header(isMac: Boolean): PlyHeader {
        closeElement()
        val format = format ?: fail("the header names no format")
        if ("vertex" !in elements) fail("the header has no element vertex")

        // If lines end with a carriage return alone, a line feed after the last one is the body's first byte
        val isFirstOfBody = isMac && lines.bytes[lines.position - 1] == LINE_FEED
        val position = if (isFirstOfBody) lines.passed - 1 else lines.passed
        return PlyHeader(format, elements.values.toList(), position, lines.number + 1, textureFiles)
    }

    private fun comment(words: List<String>) {
        if (words.getOrNull(1).equals("TextureFile", ignoreCase = true)) {
            source.loading.items(source, 1)
            textureFiles.add(words.drop(2).joinToString(" "))
        }
    }

    private fun format(words: List<String>) {
        val id = words.getOrNull(1)
        format = PlyFormat.entries.firstOrNull { it.id == id }
            ?: fail("the format \"$id\" is unknown", "it is one of ${PlyFormat.entries.joinToString { it.id }}")
        val version = words.getOrNull(2)
        if (version != "1.0") fail("the version is \"$version\", not 1.0")
    }

    private fun element(words: List<String>) {
        closeElement()
        val name = words.getOrNull(1) ?: fail("the element has no name")
        val count = words.getOrNull(2)?.toIntOrNull()?.takeIf { it >= 0 }
            ?: fail("the count of element $name must be a whole number in 0..${Int.MAX_VALUE}: ${words.getOrNull(2)}")
        if (name in elements) fail("there is a second element $name")
        source.loading.items(source, 1)
        open = Pair(name, count)
    }

    private fun closeElement() {
        open?.let { (name, count) -> elements[name] = PlyElement(name, count, properties.toList()) }
        properties.clear()
        open = null
    }

    private fun property(words: List<String>) {
        if (open == null) fail("a property stands before the first element")
        val isList = words.getOrNull(1) == "list"
        val name = words.getOrNull(if (isList) 4 else 2) ?: fail("the property has no name")
        val type = type(words[if (isList) 3 else 1])
        source.loading.items(source, 1)
        properties.add(PlyProperty(name, type, if (isList) type(words[2]) else null))
    }

    private fun type(name: String): PlyType = PlyType.of(name)
        ?: fail("the type \"$name\" is unknown", "it is one of ${PlyType.entries.joinToString { it.names[0] }}")

    private fun fail(problem: String, remedy: String = "correct the header or export the model again"): Nothing =
        source.fail("line ${lines.number}", problem, remedy)

    private companion object {
        const val LINE_FEED = '\n'.code.toByte()
        const val CARRIAGE_RETURN = '\r'.code.toByte()
    }
}
