package dev.lazyz.scenes.ply

/** One row of an element: [numbers] by column, and [lists] by column where the column is a list. Used over and over. */
internal class PlyRow(val element: PlyElement) {
    /** By column, as arrays, for they are read for each number. */
    val properties: Array<PlyProperty> = element.properties.toTypedArray()

    val numbers = DoubleArray(properties.size)
    val lists = Array(properties.size) { PlyList() }
}

/** Numbers of a list; longer lists make it longer. */
internal class PlyList {
    /** The numbers, and what longer lists before left behind them. */
    var numbers = DoubleArray(LEAST)
        private set

    var size = 0
        private set

    /** Makes room for [size] numbers, which the caller writes. */
    fun resize(size: Int) {
        if (size > numbers.size) numbers = DoubleArray(size)
        this.size = size
    }

    private companion object {
        const val LEAST = 4
    }
}
