package dev.lazyz.scenes.collections

/** Whole numbers that grow in number at the end, unboxed. Not thread safe. */
internal class Ints(capacity: Int = INITIAL_CAPACITY) {
    private var values = IntArray(capacity)

    var size = 0
        private set

    operator fun get(index: Int): Int = values[index]

    operator fun set(index: Int, value: Int) {
        values[index] = value
    }

    fun add(value: Int) {
        if (size == values.size) values = values.copyOf(size + maxOf(size / 2, INITIAL_CAPACITY))
        values[size++] = value
    }

    /** Returns the numbers; the array itself where it is full, so add no more. */
    fun toArray(): IntArray = if (size == values.size) values else values.copyOf(size)

    private companion object {
        const val INITIAL_CAPACITY = 16
    }
}
