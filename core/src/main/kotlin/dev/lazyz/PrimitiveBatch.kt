package dev.lazyz

/**
 * Consecutive primitives of a frame, stored together without an object for each. They are converted to single
 * primitives only for renderers that need them. Immutable and thread safe.
 */
internal interface PrimitiveBatch {
    /** Submission index of the first primitive. */
    val first: Int

    /** Number of primitives, including those that are not drawn from this batch. */
    val count: Int

    /** The primitives that must be drawn one by one, with their number in this batch. */
    val exceptions: List<IndexedValue<Primitive>>

    /** Whether primitive [number], 0 until [count], is drawn from this batch. */
    fun isDrawn(number: Int): Boolean

    /** Returns a function that returns a primitive of the batch, given its number; for one thread. */
    fun reader(): (number: Int) -> Primitive

    /** Returns this batch with primitives whose colours are not computed. */
    fun unshaded(): PrimitiveBatch

    /**
     * Returns all primitives of the batch as single primitives. Passes [checkpoint] while it prepares for the first.
     */
    fun primitives(checkpoint: Checkpoint): Sequence<Primitive>
}
