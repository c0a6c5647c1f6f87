package dev.lazyz.cli.pages

import dev.lazyz.cli.ProjectFiles
import kotlin.io.path.readLines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/** The Kotlin and Java code of the pages is compiled: its lines follow each other in a source file of the project. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class PageCodeTest {
    private val sources = ProjectFiles.written("kt", "java").map { significant(it.readLines()) }

    private val imports = sources.flatMap { source -> source.filter(::isImport) }.toSet()

    private fun significant(lines: List<String>) = lines.map { it.trim() }.filter { it.isNotEmpty() }

    private fun isImport(line: String) = line.startsWith("import ")

    private fun text(lines: List<String>) = lines.filterNot(::isImport).joinToString("\n", "\n", "\n")

    @Test
    fun isCompiled() {
        val texts = sources.map(::text)
        val blocks = FencedBlock.all.filter { it.language == "kotlin" || it.language == "java" }
        assertTrue(blocks.isNotEmpty())
        val lost = blocks.filter { block -> text(significant(block.lines)).let { code -> texts.none { code in it } } }
        assertEquals("", lost.joinToString("\n\n") { "${it.page}:\n${it.lines.joinToString("\n")}" }, "in no source")
    }

    @Test
    fun itsImportsAreThere() {
        val shown = FencedBlock.all.flatMap { significant(it.lines) }.filter { isImport(it) && "lazyz" in it }
        assertEquals(emptyList<String>(), shown.filter { it !in imports && !it.endsWith(".*;") && !isDeclared(it) })
    }

    /** Whether a source declares what [import] names: those of its package do not import it. */
    private fun isDeclared(import: String): Boolean {
        val name = import.removePrefix("import ").removeSuffix(";")
        val declaration = Regex("""\b(class|interface|object|fun) .*\b${name.substringAfterLast('.')}\b""")
        return sources.any { source ->
            source.any { it.removeSuffix(";") == "package ${name.substringBeforeLast('.')}" } &&
                source.any { declaration.containsMatchIn(it) }
        }
    }
}
