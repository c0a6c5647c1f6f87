package dev.lazyz.server.render

/**
 * A rendering that waits for its turn in a [RenderQueue].
 *
 * @param need bytes of memory that it takes, as far as it is known before the work
 * @param work renders the picture. It runs on a thread of the queue, which is interrupted if the job is cancelled. It
 *   is done again with more memory if it throws [MoreMemory]
 * @param started is called when the work begins, on the thread of the queue
 * @param released is called once, when no thread is at work any more
 * @param ended is called once, with the picture or the problem: after that, or, if the queue gives up, before it
 */
internal class QueuedJob(
    need: Long,
    val work: (QueuedJob) -> RenderedPicture,
    val started: () -> Unit,
    val released: () -> Unit,
    val ended: (Outcome) -> Unit,
) {
    /**
     * The result: one of the two is null. The memory of the picture stays reserved; give it back to the queue when the
     * picture has been sent.
     */
    class Outcome(val picture: RenderedPicture?, val problem: Problem?, val bug: Throwable? = null)

    /** Bytes of memory that the work takes. Guarded by the lock of the queue; during the work only that changes it. */
    var need: Long = need

    /** The thread that does the work, or null. Guarded by the lock of the queue. */
    var thread: Thread? = null

    /** Why the job was cancelled, or null. Written under the lock of the queue, while the job is at work. */
    @Volatile
    var reason: Problem? = null

    /** Whether the queue has given up on the job: it has ended, and its thread hangs. As [reason]. */
    @Volatile
    var isGivenUp = false
}

/** The work of a job needs [need] bytes of memory, more than are free: it ends, and begins again when they are. */
internal class MoreMemory(val need: Long) : RuntimeException(null, null, false, false)
