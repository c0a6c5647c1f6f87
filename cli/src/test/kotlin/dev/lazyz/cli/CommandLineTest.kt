package dev.lazyz.cli

import dev.lazyz.cli.output.Version
import dev.lazyz.strategies.Renderers
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource

class CommandLineTest {
    @Test
    fun aloneItPrintsHelp() = assertEquals(zcli("--help").done().text, zcli().done().text)

    @ParameterizedTest
    @ValueSource(strings = ["", "render", "compare", "scenes", "strategies"])
    fun helpHasUsageAndExamplesInEightyColumns(command: String) {
        val words = listOf(command, "--help").filter { it.isNotEmpty() }
        val help = zcli(*words.toTypedArray()).done().text
        assertTrue(help.startsWith("Usage: ${"zcli $command".trim()} [OPTIONS]"), help)
        assertTrue("Examples:\n  # " in help, help)
        assertEquals(listOf<String>(), help.lines().filter { it.length > 80 })
        assertEquals(help, zcli(*words.dropLast(1).toTypedArray(), "-h").done().text)
    }

    @ParameterizedTest
    @CsvSource(
        "render; 4; the scene file's, or 640x480",
        "compare; 1; the scene file's, or 640x480",
        "report; 1; the scene file's, or 640x480",
        "trace; 1; 320x240",
        delimiter = ';',
        quoteCharacter = '"',
    )
    fun helpSaysTheDefaultsOfItsCommand(command: String, samples: String, size: String) {
        val help = zcli(command, "--help").done().text.replace(Regex("\\s+"), " ")
        assertTrue("N is 1, 2, 4 or 8; default: $samples --" in help, help)
        assertTrue("one number for a square; default: $size --" in help, help)
    }

    @Test
    fun examplesOfHelpParse() {
        val helps = listOf("render", "compare", "scenes", "strategies").map { zcli(it, "--help") } + zcli("--help")
        val examples = helps.flatMap { it.text.lines() }.filter { "  zcli" in it || "| zcli" in it }
        assertTrue(examples.size > 12, "$examples")
        for (example in examples) {
            val words = example.substringAfter("zcli ").substringBefore(" >").split(" ")

            if (words[0] !in setOf("render", "compare") || "--help" in words) {
                zcli(*words.toTypedArray()).done()
                continue
            }
            // With the invalid size, an error in the example would add a line to the message
            val run = zcli(*words.toTypedArray(), "--size", "0x0").mistake("invalid value for --size")
            assertEquals(2, run.errors.trim().lines().size, run.errors)
        }
    }

    @Test
    fun version() = assertEquals("zcli ${Version.text}\n", zcli("--version").done().text)

    @Test
    fun scenesAreListedALineEach() {
        val lines = zcli("scenes").done().text.lines().dropLast(1)
        assertTrue(lines.any { it.startsWith("teapot ") }, "$lines")
        assertTrue(lines.all { it.matches(Regex("""[a-z0-9-]+ {2,}\S.*""")) }, "$lines")
    }

    @Test
    fun strategiesTellWhatTheyAreCapableOf() {
        val lines = zcli("strategies", "--long").done().text.lines().dropLast(1)
        assertEquals(zcli("strategies").text.lines().dropLast(1), lines.filterIndexed { i, _ -> i % 2 == 0 })
        for ((strategy, words) in Renderers.all().zip(lines.filterIndexed { i, _ -> i % 2 == 1 })) {
            val listed = words.trim().removeSurrounding("[", "]").split(", ")
            val expected = strategy.capabilities.map { it.name.lowercase().replace('_', ' ') }
            assertEquals(expected.ifEmpty { listOf("no promises beyond the picture") }.sorted(), listed.sorted())
        }
    }

    @Test
    fun mistakenWords() {
        zcli("rendr").mistake("no command 'rendr'", "did you mean 'render'?", "See 'zcli --help'")
        zcli("teapot").mistake("did you mean 'zcli render teapot'?")
        zcli("model.obj", "-o", "x.png").mistake("did you mean 'zcli render model.obj'?")
        zcli("xyzzy").mistake("no command 'xyzzy'\n")
        zcli("").mistake("no command ''")
        zcli("--versoin").mistake("no such option --versoin", "--version")
        zcli("scenes", "extra").mistake("unexpected extra argument (extra)", "See 'zcli scenes --help'")
        zcli("strategies", "--all").mistake("no such option --all")
        zcli("compare").mistake("missing argument INPUT", "See 'zcli compare --help'")
        zcli("render").mistake("missing argument INPUT", "See 'zcli render --help'")
    }
}
