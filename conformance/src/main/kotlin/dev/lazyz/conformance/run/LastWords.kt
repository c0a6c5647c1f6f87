package dev.lazyz.conformance.run

/**
 * Tells on standard error, when the process ends during a try, which rule and frame were on trial; and when it ends as
 * the renderer is made.
 */
internal object LastWords {
    init {
        Runtime.getRuntime().addShutdownHook(Thread({ tell() }, "lazyz-last-words"))
    }

    /** From now on the end of the process is watched. */
    fun keep(): Unit = Unit

    /** Whether the renderer is made just now, before any rule is on trial. */
    @Volatile
    var isMaking: Boolean = false

    private fun tell() {
        val trial = Trial.current
        if (trial == null) {
            if (isMaking) System.err.println("The process ends while the renderer is made; no rule is on trial yet")
            return
        }
        val where = trial.underTrial?.let { ", with\n$it" }.orEmpty()
        System.err.println("The process ends while ${trial.rule} is on trial$where")
    }
}
