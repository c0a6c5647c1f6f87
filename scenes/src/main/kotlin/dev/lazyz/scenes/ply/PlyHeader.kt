package dev.lazyz.scenes.ply

/**
 * The types of numbers, each with its two names.
 *
 * @property names how headers write it: C's name first, then the one with its size in bits
 * @property size bytes in the binary forms
 * @property most the number that means 1 where a colour is of this type
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
 * @property name what it is called
 * @property type of the number, or of each number in the list
 * @property countType of the list's length, or null if it is no list
 */
internal class PlyProperty(val name: String, val type: PlyType, val countType: PlyType?) {
    /** Least bytes in the binary forms. */
    val leastSize: Int get() = (countType ?: type).size
}

/**
 * A table of the body.
 *
 * @property name what its rows are, such as `vertex`
 * @property count number of rows
 * @property properties the columns
 */
internal class PlyElement(val name: String, val count: Int, val properties: List<PlyProperty>) {
    val hasLists: Boolean = properties.any { it.countType != null }

    /** Returns the number of the column that has one of [names], or null. */
    fun column(names: List<String>, isList: Boolean = false): Int? =
        properties.indexOfFirst { it.name in names && (it.countType != null) == isList }.takeIf { it >= 0 }
}

/** How the body is written. */
internal enum class PlyFormat(val id: String) {
    ASCII("ascii"),
    LITTLE_ENDIAN("binary_little_endian"),
    BIG_ENDIAN("binary_big_endian"),
}

/**
 * What stands before the body.
 *
 * @property format how the body is written
 * @property elements the body's tables in order
 * @property bodyPosition byte where the body begins
 * @property bodyLine number of the body's first line
 * @property textureFiles pictures for the surface, from comments of MeshLab's
 */
internal class PlyHeader(
    val format: PlyFormat,
    val elements: List<PlyElement>,
    val bodyPosition: Int,
    val bodyLine: Int,
    val textureFiles: List<String>,
)
