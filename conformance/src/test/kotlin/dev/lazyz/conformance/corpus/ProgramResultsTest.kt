package dev.lazyz.conformance.corpus

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** The table of programs in other languages is made from their baselines. */
class ProgramResultsTest {
    private val folder = Path.of("corpus/results")
    private val page = Path.of("corpus/README.md")

    /** `-Dlazyz.update=true` writes the table. */
    @Test
    fun tableIsThatOfTheBaselines() {
        val files = Files.list(folder).use { it.sorted().toList() }
        val kinds = SceneResult.entries.filter { it != SceneResult.INCONCLUSIVE && it != SceneResult.NOT_RUN }
        val head = listOf("program", "version", "date", "processor") + kinds.map { it.words } + "wrong in"
        val rows = files.map { file ->
            val facts = file.readLines().filter { it.startsWith("# ") }.associate {
                it.drop(2).substringBefore('=') to it.substringAfter('=')
            }
            assertEquals("${CorpusFiles.VERSION}", facts["corpus"], file.name)
            val results = checkNotNull(Baseline.read(file))
            assertEquals(340, results.size, file.name)
            val groups = results.filter { it.value.isFailure }.keys.map { it.substringAfter('-').substringBefore('-') }
            listOf("[${facts["program"]}](results/${file.name})") +
                listOf("version", "date", "processor").map { facts[it].orEmpty() } +
                kinds.map { kind -> "${results.values.count { it == kind }}" } +
                groups.groupingBy { it }.eachCount().entries.joinToString { "${it.key} (${it.value})" }
        }
        val lines = listOf(head, head.map { "---" }) + rows
        val table = lines.joinToString("\n") { "| ${it.joinToString(" | ")} |".replace("|  |", "| |") }
        val text = page.readText()
        val before = text.substringBefore("## Results\n\n") + "## Results\n\n"
        val after = "\n\nA scene is exact" + text.substringAfter("A scene is exact")
        if (System.getProperty("lazyz.update") == "true") page.writeText(before + table + after)
        assertEquals(before + table + after, page.readText(), "write it with -Dlazyz.update=true")
    }
}
