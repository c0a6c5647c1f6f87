package dev.lazyz.conformance

/** Tells on standard error, when the process ends during a try, which rule and frame were on trial. */
internal object LastWords {
    init {
        Runtime.getRuntime().addShutdownHook(Thread({ tell() }, "lazyz-last-words"))
    }

    /** From now on the end of the process is watched. */
    fun keep(): Unit = Unit

    private fun tell() {
        val trial = Trial.current ?: return
        val where = trial.underTrial?.let { ", with\n$it" }.orEmpty()
        System.err.println("The process ends while ${trial.rule} is on trial$where")
    }
}
