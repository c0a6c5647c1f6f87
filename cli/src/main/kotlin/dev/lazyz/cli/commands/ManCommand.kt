package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.ManPage
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Version

/** `zcli man`: the manual page, from the texts of `--help`. Used below the command `zcli`. */
internal class ManCommand(private val streams: Streams) : Command(NAME) {
    override fun help(context: Context): String =
        "Prints the manual page, for the command 'man'. It contains what '--help' prints for all commands."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli man | man -l -" to "reads it",
        "zcli man > ~/.local/share/man/man1/zcli.1" to "installs it for 'man zcli'",
    )

    override fun run() {
        val zcli = checkNotNull(currentContext.parent)
        val page = ManPage(Version.text, zcli.command)
        for (command in zcli.command.registeredSubcommands()) {
            if (command !== this) command.resetContext(zcli)
            page.add(command)
        }
        streams.print(page.text())
    }

    companion object {
        const val NAME = "man"
    }
}
