package dev.lazyz

/**
 * A place in long work at which it may end. Work passes one for each row, primitive, span of edges or shading call, so
 * that nothing long lies between two of them. Cost: about a nanosecond.
 */
internal fun interface Checkpoint {
    /** Throws an exception if the work must end. */
    fun pass()

    companion object {
        /** Never ends the work: for rows that a caller asks for one by one. */
        val NONE: Checkpoint = Checkpoint {}

        /** For work of the calling thread, see [endIfInterrupted]. */
        val CALLER: Checkpoint = Checkpoint { endIfInterrupted() }

        /** A loop with little work for each [number] passes a checkpoint where this is true. */
        fun isDue(number: Int): Boolean = number and EACH == 0

        private const val EACH = 0xFFF
    }
}

/**
 * For work of the thread that makes this, up to [close]. What other threads do goes on, and so does what is done later:
 * their interrupts are not those of the caller.
 */
internal class OwnCheckpoint :
    Checkpoint,
    AutoCloseable {
    @Volatile
    private var owner: Thread? = Thread.currentThread()

    override fun pass() {
        if (owner === Thread.currentThread()) endIfInterrupted()
    }

    override fun close() {
        owner = null
    }
}

/** Ends the work of this thread if it is interrupted: throws InterruptedException, and clears the status. */
internal fun endIfInterrupted() {
    if (Thread.interrupted()) throw InterruptedException("interrupted while rendering")
}
