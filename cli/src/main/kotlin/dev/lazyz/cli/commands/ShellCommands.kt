package dev.lazyz.cli.commands

import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.types.choice
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.ManPage
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Version

/** `zcli completion`: a script for a shell. Used below the command `zcli`, whose other commands it describes. */
internal class CompletionCommand(private val streams: Streams) : Command(NAME) {
    private val shell by argument("SHELL", help = "bash, zsh or fish").choice("bash", "zsh", "fish")

    override fun help(context: Context): String =
        "Prints a script with which a shell completes commands, options, values that are names, and files."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli completion bash > ~/.local/share/bash-completion/completions/zcli" to "for bash-completion",
        "zcli completion zsh > ~/.zcli.zsh" to "for zsh; add 'source ~/.zcli.zsh' to .zshrc",
        "zcli completion fish > ~/.config/fish/completions/zcli.fish" to "for fish",
    )

    override fun run() {
        val zcli = checkNotNull(currentContext.parent).command
        streams.print(withValues(CompletionGenerator.generateCompletionForCommand(zcli, shell)).trimEnd() + "\n")
    }

    /** Returns [script], for bash and zsh such that it offers values that begin with `-`, as those of `--up`. */
    private fun withValues(script: String): String =
        script.replace("if [[ \"\${word}\" =~", "if [[ -z \"\${in_param}\" && \"\${word}\" =~")

    companion object {
        const val NAME = "completion"
    }
}

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
