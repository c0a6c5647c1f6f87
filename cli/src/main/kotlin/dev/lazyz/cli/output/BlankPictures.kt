package dev.lazyz.cli.output

import dev.lazyz.Image
import dev.lazyz.scenes.pictures.Blank
import dev.lazyz.scenes.pictures.VisibleRows

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

    /** Reports why there is nothing to see in [image], the picture [what], unless there is something. */
    fun report(image: Image, streams: Streams, what: String): Unit = report(reason(image), streams, what)

    /** Returns the exit code of a command that otherwise has the exit code [other]. */
    fun code(other: Int): Int = if (isMistake && isFound && other == ExitCode.DONE) ExitCode.DIFFERENT else other

    companion object {
        /** Returns why there is nothing to see in [image], or null if there is something. */
        fun reason(image: Image): String? = reason(VisibleRows(image.width).apply { add(image) }.blank)

        /** Returns [blank] in words. */
        fun reason(blank: Blank?): String? = when (blank) {
            Blank.BACKGROUND -> "nothing is visible: the picture is all background"

            Blank.ONE_COLOR ->
                "all pixels have the same colour, also those of the background; " +
                    "choose another --background, --light or --color"

            null -> null
        }
    }
}
