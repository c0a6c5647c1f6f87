package dev.lazyz.cli

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/**
 * Java cannot catch a checked exception that no method declares. So what is public, and documents one, has `@Throws`
 * for it. `JavaExceptionsTest` of `scenes` catches them.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class DeclaredExceptionsTest {
    @Test
    fun documentedCheckedExceptionsAreDeclared() {
        val sources = MODULES.flatMap { sources(ProjectFiles.folderOf(it).resolve("src/main/kotlin")) }
        val texts = sources.associate { ProjectFiles.root.relativize(it) to it.readText() }
        assertEquals(emptyList<String>(), texts.flatMap { (path, text) -> undeclared(text).map { "$path: $it" } })
        assertTrue(texts.values.sumOf { it.split("@Throws(").size - 1 } > 50, "finds the sources")
    }

    @Test
    fun aMissingDeclarationIsFound() {
        val documented = "/**\n * @throws IOException if it fails\n */\n"
        assertEquals(listOf("IOException of: public fun a()"), undeclared("${documented}public fun a() {\n}\n"))
        assertEquals(listOf("IOException of: override fun a()"), undeclared("${documented}override fun a() = 1\n"))
        assertEquals(emptyList<String>(), undeclared("$documented@Throws(IOException::class)\npublic fun a() {\n}\n"))
        assertEquals(emptyList<String>(), undeclared("${documented}internal fun a() {\n}\n"))
    }

    private fun sources(folder: Path): List<Path> = Files.walk(folder).use { all ->
        all.filter { it.extension == "kt" }.sorted().toList()
    }

    private fun undeclared(text: String): List<String> = DOCUMENTED.findAll(text).flatMap { found ->
        val (comment, declaration) = found.destructured
        val isPublic = "public " in declaration || "override " in declaration
        val thrown = THROWS.findAll(comment).map { it.groupValues[1] }.toSet()
        thrown.filter { isPublic && "$it::class" !in declaration }.map {
            "$it of: ${declaration.trim().lines().last().trim()}"
        }
    }.toList()

    private companion object {
        val MODULES = listOf("core", "scenes", "conformance", "testing", "server", "spark", "swing")

        /** A comment, and what follows up to the body. */
        val DOCUMENTED = Regex("""/\*\*((?:(?!\*/).)*)\*/([^{=]*)""", RegexOption.DOT_MATCHES_ALL)
        val THROWS = Regex("""@throws (?:java\.io\.)?(IOException|InterruptedException)\b""")
    }
}
