package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.context
import dev.lazyz.cli.output.Nearest

/** What all commands of zcli have in common: how they read their words and lay out their help. */
internal abstract class Command(name: String) : CoreCliktCommand(name) {
    init {
        context {
            // A file's name may begin with @
            readArgumentFile = null
            helpFormatter = { HelpText }
            suggestTypoCorrection = { word, names -> listOfNotNull(Nearest.of(word, names)) }
        }
    }
}
