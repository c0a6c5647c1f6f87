package dev.lazyz.scenes.collections

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
