package dev.lazyz.cli.output

import dev.lazyz.conformance.report.ShellWords

/** Command lines of zcli as text. */
internal object CommandLine {
    /** Returns the command with the words [args], as it is typed in a shell. */
    fun of(args: List<String>): String = (listOf("zcli") + args).joinToString(" ", transform = ShellWords::quoted)

    /** Returns [args] without the options [names], which have a value each, up to a word `--`. */
    fun without(args: List<String>, names: Set<String>): List<String> {
        val end = args.indexOf("--").let { if (it < 0) args.size else it }
        val kept = ArrayList<String>()
        var i = 0
        while (i < end) {
            val word = args[i++]
            when {
                word in names -> i++
                names.none { word.startsWith(if (it.startsWith("--")) "$it=" else it) } -> kept.add(word)
            }
        }
        return kept + args.drop(end)
    }
}
