package dev.lazyz.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.subcommands
import com.github.ajalt.clikt.parameters.options.versionOption
import dev.lazyz.cli.commands.CompareCommand
import dev.lazyz.cli.commands.CompletionCommand
import dev.lazyz.cli.commands.ConformanceCommand
import dev.lazyz.cli.commands.DiffCommand
import dev.lazyz.cli.commands.ManCommand
import dev.lazyz.cli.commands.RenderCommand
import dev.lazyz.cli.commands.ReportCommand
import dev.lazyz.cli.commands.ScenesCommand
import dev.lazyz.cli.commands.StrategiesCommand
import dev.lazyz.cli.commands.TraceCommand
import dev.lazyz.cli.commands.ViewCommand
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Version
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.text.EditDistance

/**
 * The command `zcli`, which only contains subcommands.
 *
 * @param args the words of the command line; if the first is the name of a subcommand, only that one is built, so that
 *   zcli starts faster, unless it is about all of them
 */
internal class Zcli(streams: Streams, args: List<String>) : Command("zcli") {
    override val printHelpOnEmptyArgs: Boolean get() = true

    init {
        versionOption(Version.text, help = "Print the version and exit", message = { "zcli $it" })
        val first = args.firstOrNull()
        if (first != null && first !in NAMES && !first.startsWith("-")) throw unknown(first)
        val needsAll = first !in NAMES || first == ManCommand.NAME || first == CompletionCommand.NAME
        subcommands((if (needsAll) NAMES else listOfNotNull(first)).map { command(it, streams, args) })
    }

    private fun command(name: String, streams: Streams, args: List<String>): Command = when (name) {
        "render" -> RenderCommand(streams, args)
        "view" -> ViewCommand(streams)
        "compare" -> CompareCommand(streams, args)
        "diff" -> DiffCommand(streams)
        "report" -> ReportCommand(streams, args)
        "trace" -> TraceCommand(streams)
        "conformance" -> ConformanceCommand(streams, args)
        "scenes" -> ScenesCommand(streams)
        "strategies" -> StrategiesCommand(streams)
        ManCommand.NAME -> ManCommand(streams)
        CompletionCommand.NAME -> CompletionCommand(streams)
        else -> error("there is no command '$name'")
    }

    override fun help(context: Context): String =
        "Turns 3D models into pictures, without a GPU, a display or native code: the same bits on every machine."

    override fun helpEpilog(context: Context): String =
        "'zcli' stands for 'java -jar zcli.jar'.\n\n" + HelpText.examples(
            "zcli render teapot -o teapot.png" to "a built-in scene",
            "zcli render model.obj --view iso -o model.png" to "your own model",
            "zcli render --help" to "all options",
        )

    override fun run() = Unit

    /** Returns the error for an unknown command. If the word is an input, suggests 'zcli render'. */
    private fun unknown(word: String): Mistake {
        val isInput = SceneFormat.ofFileName(word) != null || Scenes.builtins.any { it.id == word }
        val hint = when {
            isInput -> "; did you mean 'zcli render $word'?"
            word == "help" -> "; did you mean 'zcli --help'?"
            else -> EditDistance.hint(word, NAMES)
        }
        return Mistake("no command '$word'$hint\nSee 'zcli --help'.")
    }

    private companion object {
        val NAMES = listOf(
            "render", "view", "compare", "diff", "report", "trace", "conformance", "scenes", "strategies",
            ManCommand.NAME, CompletionCommand.NAME,
        )
    }
}
