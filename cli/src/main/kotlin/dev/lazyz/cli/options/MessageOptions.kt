package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Streams

/** Options of what is printed to standard error, and of the exit code. */
internal class MessageOptions : OptionGroup("Messages and exit code") {
    private val isQuiet by option(
        "--quiet",
        help = "Print no progress to standard error, only warnings and errors; default: what is done is shown if it " +
            "is a terminal; otherwise, long work prints a line every ten seconds",
    ).flag()

    private val isBlankMistake by option(
        "--fail-blank",
        help = "Exit code 1, and an error in place of a warning, if there is nothing to see in a picture: it is all " +
            "background, or has one colour; files are still written",
    ).flag()

    /** Applies the options to [streams], and returns what happens if a picture is blank. */
    fun applyTo(streams: Streams): BlankPictures {
        streams.isQuiet = isQuiet
        return BlankPictures(isBlankMistake)
    }
}
