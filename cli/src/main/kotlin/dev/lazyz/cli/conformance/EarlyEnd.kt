package dev.lazyz.cli.conformance

/**
 * What happens if this process is asked to end, for example by SIGTERM, while child processes run: they are ended, and
 * then [delete] deletes the files of both.
 */
internal class EarlyEnd(private val delete: () -> Unit) {
    @Volatile
    private var hasBegun = false

    private val hook = Thread({ end() }, "zcli-early-end").also { Runtime.getRuntime().addShutdownHook(it) }

    private fun end() {
        hasBegun = true

        // A child that still runs would create its file again
        for (child in ProcessHandle.current().children()) {
            child.destroyForcibly()
            child.onExit().join()
        }
        delete()
    }

    /** Waits for the end of this process if it was asked to end. Call it when a child has ended. */
    fun awaitIfBegun() {
        while (hasBegun) Thread.sleep(MOMENT)
    }

    /** Withdraws this, unless it has begun. */
    fun withdraw() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (_: IllegalStateException) {
            // This process is ending
            awaitIfBegun()
        }
    }

    private companion object {
        const val MOMENT = 100L
    }
}
