package dev.lazyz

/** A primitive that covers no sample. It replaces primitives that are degenerate or not visible (contract rule 9.4). */
internal object EmptyPrimitive : Primitive {
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = 0
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = 0

    override fun spans(y: Int, spans: Spans) = Unit

    override fun depth(x: Int, y: Int): Int = error("an empty primitive has no depth")

    override fun shade(fragment: Fragment) = error("an empty primitive has no colour")

    override fun toString(): String = "EmptyPrimitive"
}
