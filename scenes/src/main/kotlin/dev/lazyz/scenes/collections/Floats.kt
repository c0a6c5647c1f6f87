package dev.lazyz.scenes.collections

/** A growing list of floats, unboxed. Not thread safe. */
internal class Floats(capacity: Int = INITIAL_CAPACITY) {
    private var values = FloatArray(capacity)

    var size = 0
        private set

    operator fun get(index: Int): Float = values[index]

    fun add(value: Float) {
        if (size == values.size) values = values.copyOf(grownCapacity(size, 1))
        values[size++] = value
    }

    fun clear() {
        size = 0
    }

    /** Returns the numbers in the list's own array, trimmed to [size]. Do not add numbers afterwards. */
    fun toArray(): FloatArray {
        if (size < values.size) values = values.copyOf(size)
        return values
    }

    private companion object {
        const val INITIAL_CAPACITY = 16
    }
}
