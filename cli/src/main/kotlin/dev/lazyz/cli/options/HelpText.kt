package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.output.HelpFormatter
import com.github.ajalt.clikt.output.HelpFormatter.ParameterHelp

/** Formats `--help` for a terminal of 80 columns: description, arguments, options by group, examples. */
internal object HelpText : HelpFormatter {
    private const val WIDTH = 80
    private const val COLUMN = 28

    override fun formatHelp(
        error: UsageError?,
        prolog: String,
        epilog: String,
        parameters: List<ParameterHelp>,
        programName: String,
    ): String = buildString {
        appendLine("Usage: ${usage(programName, parameters)}")
        appendLine()
        appendLine(wrap(prolog, 0))
        for ((title, rows) in sections(parameters)) section(title, rows)
        if (epilog.isNotEmpty()) append("\n").append(epilog)
    }

    /** Returns the form of a command line of [programName]. */
    fun usage(programName: String, parameters: List<ParameterHelp>): String {
        val operands = if (parameters.any { it is ParameterHelp.Subcommand }) {
            " COMMAND [ARGS]"
        } else {
            parameters.filterIsInstance<ParameterHelp.Argument>().joinToString("") {
                if (it.repeatable) " ${it.name}..." else " ${it.name}"
            }
        }
        return "$programName [OPTIONS]$operands"
    }

    /** Returns the titles of all sections, each with its rows: a term, and what it means. */
    fun sections(parameters: List<ParameterHelp>): List<Pair<String, List<Pair<String, String>>>> {
        val arguments = parameters.filterIsInstance<ParameterHelp.Argument>().map { it.name to it.help }
        val commands = parameters.filterIsInstance<ParameterHelp.Subcommand>().map { it.name to it.help }

        // Options without a group come first, or last if the only one is --help
        val groups = parameters.filterIsInstance<ParameterHelp.Option>().groupBy { it.groupName }
        val plain = groups[null].orEmpty()
        val named = groups - null
        val ordered = if (plain.size > 1) mapOf(null to plain) + named else named + (null to plain)
        val options = ordered.map { (group, all) -> "${group ?: "Options"}:" to all.map { term(it) to it.help } }
        return (listOf("" to arguments, "Commands:" to commands) + options).filter { it.second.isNotEmpty() }
    }

    /** Returns a section of command lines, each below its purpose. */
    fun examples(vararg lines: Pair<String, String>): String =
        lines.joinToString("\n", prefix = "Examples:\n") { (command, purpose) -> "  # $purpose\n  $command" }

    private fun StringBuilder.section(title: String, rows: List<Pair<String, String>>) {
        appendLine()
        if (title.isNotEmpty()) appendLine(title)
        for ((term, text) in rows) {
            val lead = "  $term"
            val body = wrap(text, COLUMN)
            // A long term has a separate line
            if (lead.length + 2 > COLUMN) appendLine(lead) else append(lead.padEnd(COLUMN))
            appendLine(if (lead.length + 2 > COLUMN) body else body.trimStart())
        }
    }

    private fun term(option: ParameterHelp.Option): String {
        val names = option.names.sortedBy { it.length }.joinToString(", ")
        val metavar = option.metavar ?: return names
        return if (option.nvalues.first == 0) "$names[=$metavar]" else "$names $metavar"
    }

    /** Wraps [text], and indents all lines by [indent] spaces. */
    private fun wrap(text: String, indent: Int): String = buildString {
        val margin = " ".repeat(indent)
        for (paragraph in text.split("\n")) {
            var column = 0
            for (word in paragraph.split(" ").filter { it.isNotEmpty() }) {
                if (column > 0 && column + 1 + word.length > WIDTH - indent) {
                    append("\n")
                    column = 0
                }
                if (column == 0) append(margin) else append(" ")
                append(word)
                column += word.length + if (column == 0) 0 else 1
            }
            append("\n")
        }
    }.trimEnd()
}
