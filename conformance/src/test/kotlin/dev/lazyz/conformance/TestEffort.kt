package dev.lazyz.conformance

/**
 * How much the longest tests try. `mvn verify` alone tries a part of the wrong renderers and of the frames, always the
 * same part, so that it takes minutes. `-Dlazyz.effort=rest` tries another part, which is what the continuous build
 * does on its second JDK; `-Dlazyz.effort=full` tries all. Other tests that take long are annotated with
 * `@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")`, and those that need not run again on
 * another JDK with `@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")`.
 */
internal object TestEffort {
    private val effort: String? = System.getProperty("lazyz.effort")
    private val isRest: Boolean get() = effort == "rest"

    val isDefault: Boolean get() = effort == null
    val isFull: Boolean get() = effort == "full"

    /** Returns each [step]th element; with the effort `rest` each one that follows these, with `full` all. */
    fun <T> sample(step: Int, all: List<T>): List<T> =
        if (isFull) all else all.filterIndexed { i, _ -> i % step == if (isRest) 1 else 0 }
}
