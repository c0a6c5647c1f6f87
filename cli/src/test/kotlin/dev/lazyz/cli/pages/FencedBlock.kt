package dev.lazyz.cli.pages

import dev.lazyz.cli.ProjectFiles
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.readLines
import kotlin.io.path.relativeTo

/**
 * A fenced block of a page.
 *
 * @property page path of the page, from the root of the project
 * @property language what follows the fence: `sh` for commands
 * @property note the comment in the line before: `run: NAME` for commands that `.ci/run` runs, and `not run: WHY`
 * @property lines its content
 */
internal class FencedBlock(val page: String, val language: String, val note: String, val lines: List<String>) {
    /** The first line: with [page], the name of a block. */
    val name: String get() = "$page: ${lines.first()}"

    companion object {
        private val COMMENT = Regex("""<!-- (.*) -->""")

        /** All blocks of all pages of the project. */
        val all: List<FencedBlock> = ProjectFiles.written("md").flatMap { blocks(it) }

        private fun blocks(page: Path): List<FencedBlock> {
            val path = page.relativeTo(ProjectFiles.root).invariantSeparatorsPathString
            val found = ArrayList<FencedBlock>()
            var language: String? = null
            var before = ""
            var note = ""
            val lines = ArrayList<String>()
            for (line in page.readLines()) {
                val fence = line.trimStart().takeIf { it.startsWith("```") }
                when {
                    fence == null -> if (language != null) lines += line
                    language == null -> {
                        language = fence.removePrefix("```")
                        note = COMMENT.matchEntire(before)?.groupValues?.get(1).orEmpty()
                    }
                    else -> {
                        found += FencedBlock(path, language, note, lines.toList())
                        lines.clear()
                        language = null
                    }
                }
                before = line
            }
            check(language == null) { "$path: a block does not end" }
            return found
        }
    }
}
