package dev.lazyz.conformance.run

/**
 * If the process ends during a try, prints the rule and the frame to standard error. Also prints a message if the
 * process ends while the renderer is created.
 */
internal object LastWords {
    init {
        Runtime.getRuntime().addShutdownHook(Thread({ tell() }, "lazyz-last-words"))
    }

    /** Starts watching for the end of the process. */
    fun keep(): Unit = Unit

    /** Whether the renderer is being created, before any rule runs. */
    @Volatile
    var isMaking: Boolean = false

    private fun tell() {
        val trial = Trial.current
        if (trial == null) {
            if (isMaking) System.err.println("The process ends while the renderer is created, before the first rule")
            return
        }
        val where = trial.underTrial?.let { ", with\n$it" }.orEmpty()
        System.err.println("The process ends while ${trial.rule} is running$where")
    }
}
