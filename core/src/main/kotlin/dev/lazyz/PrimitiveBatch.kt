package dev.lazyz

/**
 * Consecutive primitives of a frame which are kept together, without an object for each. They are made one by one only for
 * renderers that ask for them. Immutable and thread safe.
 */
internal interface PrimitiveBatch {
    /** Submission index of the first. */
    val first: Int

    /** How many there are, those that are not drawn from here included. */
    val count: Int

    /** The primitives that have to be drawn one by one, by their number in this batch. */
    val exceptions: List<IndexedValue<Primitive>>

    /** Whether primitive [number] is drawn from this batch. */
    fun isDrawn(number: Int): Boolean

    /** Returns all of them as primitives of their own. */
    fun primitives(): Sequence<Primitive>
}
