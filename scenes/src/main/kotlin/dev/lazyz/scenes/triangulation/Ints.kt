package dev.lazyz.scenes.triangulation

/** Whole numbers that grow in number at the end, unboxed. Not thread safe. */
internal class Ints {
    private var values = IntArray(INITIAL_CAPACITY)

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

    fun clear() {
        size = 0
    }

    fun toArray(): IntArray = values.copyOf(size)
}

private const val INITIAL_CAPACITY = 16
