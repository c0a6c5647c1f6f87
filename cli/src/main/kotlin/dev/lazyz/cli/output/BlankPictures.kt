package dev.lazyz.cli.output

/**
 * What happens if there is nothing to see in a picture: a warning or, if [isMistake], an error, and the exit code for
 * pictures that are not as they should be. Thread safe.
 */
internal class BlankPictures(val isMistake: Boolean) {
    @Volatile
    private var isFound = false

    /** Reports [reason], why there is nothing to see, unless it is null; of the picture [what] if there are several. */
    fun report(reason: String?, streams: Streams, what: String? = null) {
        if (reason == null) return
        isFound = true
        val message = if (what == null) reason else "$what: $reason"
        if (isMistake) streams.error(message) else streams.warning(message)
    }

    /** Returns the exit code of a command that otherwise has the exit code [other]. */
    fun code(other: Int): Int = if (isMistake && isFound && other == ExitCode.DONE) ExitCode.DIFFERENT else other
}
