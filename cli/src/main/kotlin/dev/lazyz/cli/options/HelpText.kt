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
        val arguments = parameters.filterIsInstance<ParameterHelp.Argument>()
        val commands = parameters.filterIsInstance<ParameterHelp.Subcommand>()
        val operands = if (commands.isEmpty()) {
            arguments.joinToString("") {
                if (it.repeatable) " ${it.name}..." else " ${it.name}"
            }
        } else {
            " COMMAND [ARGS]"
        }
        appendLine("Usage: $programName [OPTIONS]$operands")
        appendLine()
        appendLine(wrap(prolog, 0))
        section("", arguments.map { it.name to it.help })
        section("Commands:", commands.map { it.name to it.help })

        // Print options by group. Options without a group come first, or last if the only one is --help
        val groups = parameters.filterIsInstance<ParameterHelp.Option>().groupBy { it.groupName }
        val plain = groups[null].orEmpty()
        val named = groups - null
        for ((group, members) in if (plain.size > 1) mapOf(null to plain) + named else named + (null to plain)) {
            section("${group ?: "Options"}:", members.map { term(it) to it.help })
        }
        if (epilog.isNotEmpty()) append("\n").append(epilog)
    }

    /** Returns a section of command lines, each below its purpose. */
    fun examples(vararg lines: Pair<String, String>): String =
        lines.joinToString("\n", prefix = "Examples:\n") { (command, purpose) -> "  # $purpose\n  $command" }

    private fun StringBuilder.section(title: String, rows: List<Pair<String, String>>) {
        if (rows.isEmpty()) return
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
