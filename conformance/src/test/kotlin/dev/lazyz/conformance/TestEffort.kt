package dev.lazyz.conformance

/**
 * How much the longest tests try. The default build tests a part of the wrong renderers and of the frames, always the
 * same part. The continuous build tests another part on its second JDK with `-Dlazyz.part=1`; `-Dlazyz.effort=full`
 * tests all of them.
 */
internal object TestEffort {
    val isFull: Boolean = System.getProperty("lazyz.effort") == "full"
    private val part = Integer.getInteger("lazyz.part", 0)

    /** Returns every [step]th element, or all. */
    fun <T> oneOf(step: Int, all: List<T>): List<T> =
        if (isFull) all else all.filterIndexed { i, _ -> i % step == part % step }
}
