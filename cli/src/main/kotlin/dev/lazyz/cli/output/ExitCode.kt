package dev.lazyz.cli.output

/** The exit codes of zcli. */
internal object ExitCode {
    const val DONE = 0

    /** Pictures differ, a strategy failed, or a strategy does not conform. */
    const val DIFFERENT = 1

    /** A mistake of the user, or a bad file. */
    const val MISTAKE = 2

    /** A bug in zcli: `EX_SOFTWARE` of sysexits.h. */
    const val BUG = 70

    /** The machine was too busy to tell whether a strategy conforms: `EX_TEMPFAIL` of sysexits.h. */
    const val INCONCLUSIVE = 75
}
