package dev.lazyz.cli.pages

import dev.lazyz.cli.ProjectFiles
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.relativeTo
import kotlin.io.path.walk

/**
 * A fenced block of a page.
 *
 * @property page path of the page, from the root of the project
 * @property language what follows the fence: `sh` for commands
 * @property lines its content
 */
internal class FencedBlock(val page: String, val language: String, val lines: List<String>) {
    /** The first line: with [page], the name of a block. */
    val name: String get() = "$page: ${lines.first()}"

    companion object {
        private val built = setOf("target", "build", "node_modules")

        /** All blocks of all pages of the project. */
        val all: List<FencedBlock> = ProjectFiles.root.walk()
            .filter { it.extension == "md" && it.relativeTo(ProjectFiles.root).none { part -> part.name in built } }
            .sorted()
            .flatMap { blocks(it) }
            .toList()

        private fun blocks(page: Path): List<FencedBlock> {
            val path = page.relativeTo(ProjectFiles.root).invariantSeparatorsPathString
            val found = ArrayList<FencedBlock>()
            var language: String? = null
            val lines = ArrayList<String>()
            for (line in page.readLines()) {
                val fence = line.trimStart().takeIf { it.startsWith("```") }
                when {
                    fence == null -> if (language != null) lines += line
                    language == null -> language = fence.removePrefix("```")
                    else -> {
                        found += FencedBlock(path, language, lines.toList())
                        lines.clear()
                        language = null
                    }
                }
            }
            check(language == null) { "$path: a block does not end" }
            return found
        }
    }
}
