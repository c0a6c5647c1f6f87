package dev.lazyz.cli

import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.context

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
