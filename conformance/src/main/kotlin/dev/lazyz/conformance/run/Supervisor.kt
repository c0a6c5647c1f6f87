package dev.lazyz.conformance.run

/** Ends this process when the supervising process ends, for example because it was killed: the report would be lost. */
internal object Supervisor {
    /** Environment variable that contains the process id of the supervising process, set by `Supervision`. */
    const val VARIABLE: String = "LAZYZ_SUPERVISOR"

    init {
        System.getenv(VARIABLE)?.toLongOrNull()?.let { id ->
            val end = Runnable { Runtime.getRuntime().halt(1) }
            ProcessHandle.of(id).ifPresentOrElse({ it.onExit().thenRun(end) }, end)
        }
    }

    /** Starts watching the supervising process, if there is one. */
    fun follow(): Unit = Unit
}
