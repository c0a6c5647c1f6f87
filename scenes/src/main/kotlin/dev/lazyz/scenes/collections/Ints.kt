package dev.lazyz.scenes.collections

/** A growing list of integers, unboxed. Not thread safe. */
internal class Ints(capacity: Int = INITIAL_CAPACITY) {
    private var values = IntArray(capacity)

    var size = 0
        private set

    operator fun get(index: Int): Int = values[index]

    operator fun set(index: Int, value: Int) {
        values[index] = value
    }

    /** Ensures that the list has room for [capacity] numbers in total. */
    fun ensure(capacity: Int) {
        if (capacity > values.size) values = values.copyOf(capacity)
    }

    fun add(value: Int) {
        if (size == values.size) values = values.copyOf(grownCapacity(size, 1))
        values[size++] = value
    }

    fun add(a: Int, b: Int, c: Int) {
        if (size > values.size - 3) values = values.copyOf(grownCapacity(size, 3))
        values[size] = a
        values[size + 1] = b
        values[size + 2] = c
        size += 3
    }

    fun clear() {
        size = 0
    }

    /** Whether all numbers are below [limit]. */
    fun areBelow(limit: Int): Boolean {
        for (i in 0 until size) if (values[i] >= limit) return false
        return true
    }

    /** Returns the numbers in the list's own array, trimmed to [size]. Do not add numbers afterwards. */
    fun toArray(): IntArray {
        if (size < values.size) values = values.copyOf(size)
        return values
    }

    private companion object {
        const val INITIAL_CAPACITY = 16
    }
}
