package dev.lazyz.cli

import dev.lazyz.Capability
import dev.lazyz.cli.output.ExitCode
import java.nio.file.Path
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** `docs/cli.md` and `--help` describe the same flags. */
class DocumentationTest {
    private val page: String = ProjectFiles.root.resolve("docs/cli.md").readText()

    private val commands = listOf(
        "render", "view", "compare", "diff", "report", "trace", "conformance", "scenes", "strategies", "man",
        "completion",
    )

    private fun help(vararg command: String) = zcli(*command, "--help").done().text

    /** Returns flags in the form `--flag METAVAR` or `-o`, as they appear at the beginning of a line of help. */
    private fun rows(help: String): List<String> {
        val flag = Regex("""(?m)^ {2}(-[^ ,]*(?:, --[^ ]+)?(?: [A-Zx,=:]+(?= |$))?)""")
        return flag.findAll(help).map { it.groupValues[1] }.toList()
    }

    @Test
    fun eachFlagOfHelpHasARow() {
        val flags = (listOf(help()) + commands.map { help(it) }).flatMap { rows(it) }.toSet()
        assertTrue(flags.isNotEmpty())
        val missing = flags.filter { "| `$it` |" !in page }
        assertEquals(listOf<String>(), missing, "flags of --help without a row in docs/cli.md")
    }

    @Test
    fun eachFlagOfThePageIsInHelp() {
        val helps = help() + commands.joinToString("") { help(it) }
        val known = Regex("""--?[a-z][a-z-]*""").findAll(helps).map { it.value }.toSet()
        val listed = Regex("""(?<![\w-])--?[a-z][a-z-]*""").findAll(page).map { it.value }
        val others = setOf("-jar", "-cp", "-y", "--add-modules")
        assertEquals(listOf<String>(), listed.filter { it !in known && it !in others }.toSet().toList())
    }

    @Test
    fun commandsStatisticsAndExitCodesAreListed() {
        for (command in commands) assertTrue("`zcli $command" in page, command)
        val codes = listOf(ExitCode.DONE, ExitCode.DIFFERENT, ExitCode.MISTAKE, ExitCode.BUG)
        for (code in codes) assertTrue("| `$code` |" in page, "$code")
        val json = zcli("render", "teapot", "-o", "-", "--size", "4x3", "--stats=json").errors
        val keys = Regex("\"(\\w+)\":").findAll(json).map { it.groupValues[1] }.toList()
        val rows = Regex("""\| `(\w+)` \|""").findAll(page.substringAfter("## Statistics")).map { it.groupValues[1] }
        assertEquals(keys, rows.toList(), "one row for each key of the statistics, in their order")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun keysOfAComparisonAreListed() {
        val json = zcli("compare", "teapot", "--size", "4x3", "--strategy", "zbuffer", "--json").done().text
        val own = Regex("\"(\\w+)\":").findAll(json).map { it.groupValues[1] }.toSet()
        val section = page.substringAfter("## zcli compare").substringBefore("\n## ")
        val statistics = zcli("render", "teapot", "-o", "-", "--size", "4x3", "--stats=json").errors
        for (key in own) assertTrue("`$key`" in section || "\"$key\":" in statistics, key)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun keysOfADifferenceAreListed(@TempDir folder: Path) {
        val pictures = listOf("red", "blue").map { color ->
            folder.resolve("$color.png").also {
                zcli("render", "teapot", "--size", "4x3", "--background", color, "-o", it).done()
            }
        }
        val models = zcli("diff", "teapot", "layers", "--size", "4x3", "--json").text
        val json = models + zcli("diff", *pictures.toTypedArray(), "--json").text
        val section = page.substringAfter("## zcli diff").substringBefore("\n## ")
        val keys = Regex("\"(\\w+)\":").findAll(json).map { it.groupValues[1] }.toSet()
        assertEquals(emptyList<String>(), keys.filter { "`$it`" !in section })
    }

    @Test
    fun capabilitiesAreListed() {
        val words = Capability.entries.map { it.name.lowercase().replace('_', ' ') }
        val listed = Regex("""\| ([a-z ]+) \|""").findAll(page).map { it.groupValues[1] }.filter { it in words }
        assertEquals(words, listed.toList())
    }

    @Test
    fun examplesOfThePageParse() {
        val example = Regex("""(?m)^(?:.*\| )?zcli ((?:render|compare) .*)$""")
        val examples = example.findAll(page).map { it.groupValues[1] }.toList()
        for (example in examples) {
            val words = example.substringBefore(" >").trim().split(" ")
            zcli(*words.toTypedArray(), "--zoom", "0").mistake("--zoom: must be in")
        }
    }
}
