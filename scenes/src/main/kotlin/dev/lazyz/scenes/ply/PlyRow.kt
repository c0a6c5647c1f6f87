package dev.lazyz.scenes.ply

/** One row of an element: [numbers] by column, and [lists] by column for columns that are lists. Rows are reused. */
internal class PlyRow(val element: PlyElement) {
    /** The properties by column, as an array, because they are read for each number. */
    val properties: Array<PlyProperty> = element.properties.toTypedArray()

    val numbers = DoubleArray(properties.size)
    val lists = Array(properties.size) { PlyList() }
}

/** The numbers of a list. The array grows as needed. */
internal class PlyList {
    /** The numbers. Elements from [size] on are left over from longer lists. */
    var numbers = DoubleArray(LEAST)
        private set

    var size = 0
        private set

    /** Sets the size to [size] numbers, which the caller must write. */
    fun resize(size: Int) {
        if (size > numbers.size) numbers = DoubleArray(size)
        this.size = size
    }

    private companion object {
        const val LEAST = 4
    }
}
