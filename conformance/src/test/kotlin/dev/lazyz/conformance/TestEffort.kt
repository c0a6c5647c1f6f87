package dev.lazyz.conformance

/**
 * How much the longest tests try: the usual build tries a part of the wrong renderers and of the frames, always the same. The
 * continuous build tries another part on its second JDK, by `-Dlazyz.part=1`; `-Dlazyz.effort=full` is for all of them.
 */
internal object TestEffort {
    val isFull: Boolean = System.getProperty("lazyz.effort") == "full"
    private val part = Integer.getInteger("lazyz.part", 0)

    /** Returns one of each [step] elements, or all. */
    fun <T> oneOf(step: Int, all: List<T>): List<T> =
        if (isFull) all else all.filterIndexed { i, _ -> i % step == part % step }
}
