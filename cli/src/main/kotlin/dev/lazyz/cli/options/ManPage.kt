package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.BaseCliktCommand
import dev.lazyz.cli.output.ExitCode

/**
 * A manual page in the macros `man`, with what the help of commands says.
 *
 * @param version the version of the program
 * @param program the command that contains the others
 */
internal class ManPage(version: String, program: BaseCliktCommand<*>) {
    private val roff = StringBuilder()

    init {
        val name = program.commandName
        line(".TH ${name.uppercase()} 1 \"\" \"${escaped("$name $version")}\" \"Lazy Z\"")
        line(".SH NAME")
        line("${escaped(name)} \\- turns 3D models into pictures")
        line(".SH SYNOPSIS")
        line(escaped(HelpText.usage(name, program.allHelpParams())))
        line(".SH DESCRIPTION")
        text(program.help(program.currentContext))
        text("The sections below describe its commands.")
    }

    /** Adds a section for [command]. */
    fun add(command: BaseCliktCommand<*>) {
        val context = command.currentContext
        val parameters = command.allHelpParams()
        line(".SH ${escaped(command.commandName.uppercase())}")
        line(".B ${escaped(HelpText.usage(context.commandNameWithParents().joinToString(" "), parameters))}")
        text(command.help(context))
        for ((title, rows) in HelpText.sections(parameters)) {
            if (title.isNotEmpty()) line(".SS \"${escaped(title.removeSuffix(":"))}\"")
            for ((term, meaning) in rows) {
                line(".TP")
                line(".B ${escaped(term)}")
                line(escaped(meaning))
            }
        }
        val examples = command.helpEpilog(context).lines()
        line(".SS \"${escaped(examples.first().removeSuffix(":"))}\"")
        line(".nf")
        for (example in examples.drop(1)) line(escaped(example.trimStart()))
        line(".fi")
    }

    /** Returns the page. */
    fun text(): String = roff.toString() + END

    private fun text(text: String) {
        for (paragraph in text.split("\n\n")) {
            line(".PP")
            line(escaped(paragraph.replace('\n', ' ')))
        }
    }

    private fun line(line: String) {
        roff.append(line).append('\n')
    }

    /** Returns [text] without anything that the macros would interpret. */
    private fun escaped(text: String): String {
        val safe = text.replace("\\", "\\e").replace("-", "\\-").replace("\"", "\\(dq").replace("~", "\\(ti")
            .replace("^", "\\(ha").replace("`", "\\(ga").replace("'", "\\(aq")
        return if (safe.startsWith('.')) "\\&$safe" else safe
    }

    private companion object {
        val END = """
            .SH EXIT STATUS
            .TP
            .B ${ExitCode.DONE}
            success, possibly with warnings
            .TP
            .B ${ExitCode.DIFFERENT}
            pictures differ, or a strategy does not conform
            .TP
            .B ${ExitCode.MISTAKE}
            a mistake in the command line, or a file that cannot be read or written
            .TP
            .B ${ExitCode.BUG}
            a bug in zcli; the message contains what the report needs
            .SH ENVIRONMENT
            .TP
            .B JAVA_HOME
            home of the Java to use; default: java on the PATH
            .TP
            .B ZCLI_CACHE
            folder of archives that make the start faster; if empty, there are none
            .TP
            .B ZCLI_JAVA_OPTIONS
            options for Java, separated by spaces

        """.trimIndent()
    }
}
