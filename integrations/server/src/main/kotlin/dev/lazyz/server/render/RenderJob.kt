package dev.lazyz.server.render

/**
 * A rendering that waits for its turn in a [RenderQueue].
 *
 * @property need bytes of memory that it takes
 * @param work renders the picture. It runs on a thread of the queue, which is interrupted if the job is cancelled
 * @param started is called when the work begins, on the thread of the queue
 * @param ended is called once, with the picture or the problem
 */
internal class RenderJob(
    val need: Long,
    val work: () -> Picture,
    val started: () -> Unit,
    val ended: (Outcome) -> Unit,
) {
    /**
     * The result: one of the two is null. The memory of the picture stays reserved; give it back to the queue when the
     * picture has been sent.
     */
    class Outcome(val picture: Picture?, val problem: Problem?, val bug: Throwable? = null)

    /** The thread that does the work, or null. Guarded by the lock of the queue. */
    var thread: Thread? = null

    /** Why the job was cancelled, or null. Guarded by the lock of the queue. */
    var reason: Problem? = null
}
