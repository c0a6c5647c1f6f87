package dev.lazyz.cli.batch

/**
 * Shares [total] threads among the inputs that are rendered at the same time: one for each input, and those that are
 * left for the pictures that begin next. Thread safe.
 */
internal class ThreadShare(private val total: Int) {
    private val lock = Object()
    private var free = total
    private var inputs = 0

    /** Waits for a thread, and calls [work] while it holds it. */
    fun <T> forInput(work: () -> T): T {
        synchronized(lock) {
            while (free == 0) lock.wait()
            free--
            inputs++
        }
        try {
            return work()
        } finally {
            synchronized(lock) {
                inputs--
                giveBack(1)
            }
        }
    }

    /** Calls [work] with the number of threads for a picture, at least the one that the input holds. */
    fun <T> forPicture(work: (Int) -> T): T {
        val more = synchronized(lock) {
            // The others can take the same part when they begin a picture
            ((free + inputs - 1) / inputs).also { free -= it }
        }
        try {
            return work(1 + more)
        } finally {
            synchronized(lock) { giveBack(more) }
        }
    }

    private fun giveBack(threads: Int) {
        free += threads
        check(free <= total) { "more threads were given back than taken" }
        lock.notifyAll()
    }
}
