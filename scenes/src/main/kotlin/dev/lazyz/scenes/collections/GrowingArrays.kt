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

/** Most elements that every JVM allows in one array. */
private const val MOST_ELEMENTS = Int.MAX_VALUE - 8
private const val LEAST_GROWTH = 16

/**
 * Returns a capacity of at least [size] + [more] elements, and of half as many again as [size] unless that is too many
 * for one array.
 *
 * @throws OutOfMemoryError if even [size] + [more] elements are too many, as the lists of the JDK do
 */
internal fun grownCapacity(size: Int, more: Int): Int {
    val needed = size.toLong() + more
    if (needed > MOST_ELEMENTS) throw OutOfMemoryError("an array cannot have $needed elements")
    return maxOf(needed, size.toLong() + maxOf(size / 2, LEAST_GROWTH)).coerceAtMost(MOST_ELEMENTS.toLong()).toInt()
}

/** Counts the ignored elements of a file by kind, for one warning about all of them. Not thread safe. */
internal class KindCounts {
    private val counts = LinkedHashMap<String, Int>()

    /** Number of elements that were added. */
    var total = 0
        private set

    fun add(kind: String) {
        total++
        if (counts.size < MOST_KINDS || kind in counts) counts.merge(kind, 1, Int::plus)
    }

    /** Lists the kinds in the order of the file, `2 curv, 8 vp`; kinds after the first [MOST_KINDS] are `others`. */
    override fun toString(): String {
        val named = counts.entries.joinToString { (kind, count) -> "$count $kind" }
        val others = total - counts.values.sum()
        return if (others > 0) "$named and $others others" else named
    }

    private companion object {
        const val MOST_KINDS = 8
    }
}
