package dev.lazyz.conformance

/**
 * How much the longest tests try. `-Dlazyz.effort=full` is for the continuous build; without it the tests take minutes less,
 * and try a part of the wrong renderers and of the frames, always the same.
 */
internal object TestEffort {
    val isFull: Boolean = System.getProperty("lazyz.effort") == "full"

    /** Returns one of each [count] elements, or all. */
    fun <T> oneOf(count: Int, all: List<T>): List<T> = if (isFull) all else all.filterIndexed { i, _ -> i % count == 0 }
}
