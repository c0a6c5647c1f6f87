package dev.lazyz.cli.commands

import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.types.choice
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.output.Streams

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
