package dev.lazyz

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.relativeTo
import kotlin.io.path.walk
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Links of the project's pages to files and headings lead somewhere. */
class LinksTest {
    private val root: Path = ProjectFiles.root

    private val pages: List<Path> = root.walk()
        .filter { it.extension == "md" && it.relativeTo(root).none { part -> part.name in BUILT } }
        .toList()

    /** The anchors of a page's headings, as GitHub makes them. */
    private fun anchors(page: Path): Set<String> = Regex("""(?m)^#+ (.*)$""").findAll(page.readText())
        .map { it.groupValues[1].lowercase().replace(Regex("""[^\w\- ]"""), "").replace(' ', '-') }
        .toSet()

    @Test
    fun leadSomewhere() {
        assertTrue(pages.size >= 10, "$pages")
        val broken = pages.flatMap { page ->
            Regex("""\]\(([^)\s]+)\)""").findAll(page.readText()).map { it.groupValues[1] }
                .filter { "://" !in it && !leads(page, it) }
                .map { "${page.relativeTo(root)}: $it" }
        }
        assertEquals(listOf<String>(), broken)
    }

    private fun leads(page: Path, link: String): Boolean {
        val path = link.substringBefore('#')
        val target = if (path.isEmpty()) page else page.resolveSibling(path).normalize()
        return target.exists() && ('#' !in link || link.substringAfter('#') in anchors(target))
    }

    private companion object {
        val BUILT = setOf("target", "build", "node_modules")
    }
}
