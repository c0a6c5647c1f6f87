package dev.lazyz.cli.pages

import dev.lazyz.cli.ProjectFiles
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.isExecutable
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.io.TempDir

/**
 * The commands of the pages succeed, each where it says, except those whose [note][FencedBlock.note] says that
 * `.ci/run` runs them, or why nobody does. By default only the first block of the page of the command line is run,
 * with `-Dlazyz.effort=rest` or `full` all are.
 */
class PageCommandsTest {
    private val commands = FencedBlock.all.filter { it.language == "sh" }

    /** Returns those of the [blocks] of [page] that are run. Blocks use files of those before them on their page. */
    private fun run(page: String, blocks: List<FencedBlock>): List<FencedBlock> = when {
        System.getProperty("lazyz.effort") != null -> blocks
        page == "docs/cli.md" -> blocks.take(1)
        else -> emptyList()
    }

    private val here = commands.filter { it.note.isEmpty() }

    @TestFactory
    fun succeed(@TempDir folder: Path): List<DynamicTest> {
        assumeTrue(Path.of("/bin/bash").exists(), "there is no bash")
        assertTrue(here.isNotEmpty())
        val pages = here.groupBy { it.page }.mapValues { (page, blocks) -> run(page, blocks) }
        return pages.filterValues { it.isNotEmpty() }.map { (page, blocks) ->
            dynamicTest(page) {
                val place = folder.resolve(page.replace('/', '-')).createDirectories()
                val scripts = blocks.map { smaller(it.lines.joinToString("\n")) }
                PageShell(place.resolve("files").createDirectories(), place).use { shell ->
                    shell.fill(scripts.joinToString("\n"))
                    for (script in scripts) shell.run(script)
                }
            }
        }
    }

    private fun smaller(text: String) = SMALLER.entries.fold(text) { all, (big, small) -> all.replace(big, small) }
        .replace(WITHOUT_SIZE) { "${it.value} --size 160x120" }

    /** Blocks are run in a folder that has the program that is built, but no scripts of the project. */
    @Test
    fun scriptsOfTheProjectAreNotRunInOtherFolders() {
        val scripts = here.flatMap { block ->
            block.lines.flatMap { it.split(' ') }
                .filter { '/' in it && "/target/" !in it && ProjectFiles.root.resolve(it).isExecutable() }
                .map { "${block.name}: $it" }
        }
        assertEquals(emptyList<String>(), scripts)
    }

    @Test
    fun commandsAreMarkedAsCommands() {
        val program = Regex("""^(zcli|java|mvn|gradle|curl|python3|pip|git|source|docker|\.?[\w-]+/[\w/-]+)( |$)""")
        val others = FencedBlock.all.filter { it.language.isEmpty() && program.containsMatchIn(it.lines.first()) }
        assertEquals(emptyList<String>(), others.map { it.name })
        val shells = setOf("bash", "shell", "console", "zsh", "shell-session", "sh-session", "terminal")
        assertEquals(emptyList<String>(), FencedBlock.all.filter { it.language.lowercase() in shells }.map { it.name })
    }

    @Test
    fun namedCommandsAreRunByTheScript() {
        val calls = Regex("""\bpage \S+ (\S+\.md) ([\w-]+)""").findAll(ProjectFiles.root.resolve(".ci/run").readText())
        val (named, others) = commands.filter { it.note.isNotEmpty() }.partition { it.note.startsWith("run: ") }
        assertEquals(
            calls.map { "${it.groupValues[1]}: run: ${it.groupValues[2]}" }.toSortedSet(),
            named.map { "${it.page}: ${it.note}" }.toSortedSet(),
        )
        assertEquals(emptyList<String>(), others.filterNot { it.note.startsWith("not run: ") }.map { it.name })
    }

    private companion object {
        /** Parts of commands that would take long, and what is run for them. */
        val SMALLER = mapOf(
            "--turntable 120 --size 1920x1080" to "--turntable 12 --size 192x108",
            "--turntable 36 -o" to "--turntable 12 --size 64 -o",
            "--turntable 36 --size 320" to "--turntable 12 --size 64",
            "--steps 24" to "--steps 4",
            "--size 4096x4096" to "--size 256x256",
            "--size 20000" to "--size 300",
            "--size 100000" to "--size 300",
            "--size 1024x768" to "--size 256x192",
            "--minutes 60" to "--minutes 0.01",
            "--tries 10" to "--tries 0.5",
            "my.jar --report report" to "my.jar --report report --tries 0.05 --rule 9.6",
            "--explore" to "--explore --tries 0.05 --rule 9.6",
        )

        /** The picture of a file of a failure has the size of the file. */
        val WITHOUT_SIZE =
            Regex("""\bzcli(\.jar)? (render|compare|report|trace)\b(?!(.*\\\n)*.*( --size| failures/))""")
    }
}
