package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.context
import dev.lazyz.cli.output.Nearest

/** The base class of all commands of zcli: sets how arguments are read and how help is formatted. */
internal abstract class Command(name: String) : CoreCliktCommand(name) {
    init {
        context {
            // The name of a file may begin with @
            readArgumentFile = null
            helpFormatter = { HelpText }
            suggestTypoCorrection = { word, names -> listOfNotNull(Nearest.of(word, names)) }
        }
    }
}
