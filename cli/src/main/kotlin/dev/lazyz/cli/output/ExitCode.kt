package dev.lazyz.cli.output

/** What zcli returns to the shell. */
internal object ExitCode {
    const val DONE = 0

    /** The strategies' pictures differ, a strategy failed, or it does not conform. */
    const val DIFFERENT = 1

    /** The user's mistake, or a file that is no good. */
    const val MISTAKE = 2

    /** A bug of ours: `EX_SOFTWARE` of sysexits.h. */
    const val BUG = 70
}
