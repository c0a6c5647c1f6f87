package dev.lazyz.conformance.run

/** Ends this process as soon as the one that supervises it is gone, killed for instance: nobody would read a report. */
internal object Supervisor {
    /** The environment variable by which `Supervision` tells the id of its process. */
    const val VARIABLE: String = "LAZYZ_SUPERVISOR"

    init {
        System.getenv(VARIABLE)?.toLongOrNull()?.let { id ->
            val end = Runnable { Runtime.getRuntime().halt(1) }
            ProcessHandle.of(id).ifPresentOrElse({ it.onExit().thenRun(end) }, end)
        }
    }

    /** From now on its end is watched, if there is one. */
    fun follow(): Unit = Unit
}
