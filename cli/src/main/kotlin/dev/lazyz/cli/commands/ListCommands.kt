package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.Renderer
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.formats.Scenes

/** `zcli scenes`: the built-in scenes, one line each. */
internal class ScenesCommand(private val streams: Streams) : Command("scenes") {
    override fun help(context: Context): String = "Lists the built-in scenes. 'zcli render' accepts their names."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli scenes" to "one scene per line: name and description",
        "zcli render city -o city.png" to "renders one of them",
    )

    override fun run() {
        streams.print(columns(Scenes.builtins.map { it.id to it.summary }))
    }
}

/** `zcli strategies`: the renderers, one line each, optionally followed by a line of capabilities. */
internal class StrategiesCommand(private val streams: Streams) : Command("strategies") {
    private val isLong by option("--long", help = "Also print the capabilities of each strategy").flag()

    override fun help(context: Context): String =
        "Lists the strategies for removing hidden surfaces.\n\nAll give the same picture, bit for bit; they " +
            "differ in time and memory. 'zcli compare' measures both."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli strategies" to "one strategy per line: id and description",
        "zcli strategies --long" to "also what each supports, such as blending or threads",
        "zcli render city --strategy zbuffer --stats -o city.png" to "renders with one of them, and prints statistics",
    )

    override fun run() {
        val rows = Strategies.all().flatMap { strategy ->
            listOfNotNull(strategy.id to strategy.summary, if (isLong) "" to capabilities(strategy) else null)
        }
        streams.print(columns(rows))
    }

    private fun capabilities(strategy: Renderer): String {
        val words = strategy.capabilities.sorted().map { it.name.lowercase().replace('_', ' ') }
        if (words.isEmpty()) return "[no promises beyond the picture]"
        return words.joinToString(", ", "[", "]")
    }
}

private fun columns(rows: List<Pair<String, String>>): String {
    val width = rows.maxOfOrNull { it.first.length } ?: 0
    return rows.joinToString("") { (name, text) -> "${name.padEnd(width)}  $text\n" }
}
