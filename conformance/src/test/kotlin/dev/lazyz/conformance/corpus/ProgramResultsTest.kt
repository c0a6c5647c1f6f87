package dev.lazyz.conformance.corpus

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The tables of programs in other languages are made from their baselines. */
class ProgramResultsTest {
    private val folder = Path.of("corpus/results")
    private val page = Path.of("corpus/README.md")
    private val kinds = SceneResult.entries.filter { it != SceneResult.INCONCLUSIVE && it != SceneResult.NOT_RUN }

    private class Run(val file: Path) {
        val facts = file.readLines().filter { it.startsWith("# ") }.associate {
            it.drop(2).substringBefore('=') to it.substringAfter('=')
        }
        val results = checkNotNull(Baseline.read(file))

        /** Counts of exact, within and failed scenes of a level; empty if none is supported. */
        fun cell(level: String): String {
            val all = results.filterKeys { it.startsWith("$level-") }.values
            val counts = listOf(
                all.count {
                    it == SceneResult.EXACT
                },
                all.count { it == SceneResult.WITHIN }, all.count { it.isFailure },
            )
            return if (counts.sum() == 0) "" else counts.joinToString("/")
        }
    }

    private fun table(rows: List<List<String>>): String = (rows.take(1) + listOf(rows[0].map { "---" }) + rows.drop(1))
        .joinToString("\n") { row -> row.joinToString("") { if (it.isEmpty()) "| " else "| $it " } + "|" }

    private fun programs(runs: List<Run>): String {
        val facts = listOf("version", "date", "processor")
        return table(
            listOf(listOf("program") + facts + kinds.map { it.words }) + runs.map { run ->
                listOf("[${run.facts["program"]}](results/${run.file.name})") + facts.map { run.facts[it].orEmpty() } +
                    kinds.map { kind -> "${run.results.values.count { it == kind }}" }
            },
        )
    }

    private fun levels(runs: List<Run>): String {
        val names = runs.first().results.keys.map { it.substringBeforeLast('-') }.distinct()
        return table(
            listOf(listOf("level") + runs.map { it.file.name.substringBefore('.') }) +
                names.map { level -> listOf(level) + runs.map { it.cell(level) } },
        )
    }

    /** `-Dlazyz.update=true` writes the tables. */
    @Test
    fun tablesAreThoseOfTheBaselines() {
        val runs = Files.list(folder).use { files -> files.sorted().toList() }.map { Run(it) }
        for (run in runs) {
            assertEquals("${CorpusFiles.VERSION}", run.facts["corpus"], run.file.name)
            assertEquals(380, run.results.size, run.file.name)
        }
        assertTrue(runs.size >= 7, "five programs of others, and two of the project")
        val text = page.readText()
        val made = text.substringBefore("## Results\n\n") + "## Results\n\n" + programs(runs) + "\n\nA scene is exact" +
            text.substringAfter("A scene is exact").substringBefore("| level |") + levels(runs) + "\n\nWhat differs" +
            text.substringAfter("What differs")
        if (System.getProperty("lazyz.update") == "true") page.writeText(made)
        assertEquals(made, page.readText(), "write them with -Dlazyz.update=true")
    }
}
