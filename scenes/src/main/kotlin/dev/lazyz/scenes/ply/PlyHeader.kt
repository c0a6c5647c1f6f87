package dev.lazyz.scenes.ply

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
