package dev.lazyz.scenes.triangulation

/** Numbers that grow in number at the end, unboxed. Not thread safe. */
internal class Floats {
    private var values = FloatArray(INITIAL_CAPACITY)

    var size = 0
        private set

    operator fun get(index: Int): Float = values[index]

    fun add(value: Float) {
        if (size == values.size) values = values.copyOf(size + maxOf(size / 2, INITIAL_CAPACITY))
        values[size++] = value
    }

    fun toArray(): FloatArray = values.copyOf(size)
}

private const val INITIAL_CAPACITY = 16
