package dev.lazyz.conformance.corpus

import dev.lazyz.conformance.results.reason
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.LocalDate

/**
 * What became of each scene in an earlier run of a program: a file of comma-separated values, with facts about the run
 * in lines that begin with `#`.
 */
internal object Baseline {
    private const val HEAD = "scene,result"

    /**
     * Returns the result of each scene by its name; null if there is no file at [path].
     *
     * @throws IOException if the file cannot be read
     * @throws IllegalArgumentException if it is another file; the message has the line
     */
    fun read(path: Path): Map<String, SceneResult>? {
        if (Files.notExists(path)) return null
        val lines = try {
            Files.readAllLines(path).filterNot { it.startsWith("#") || it.isBlank() }
        } catch (bad: IOException) {
            throw IOException("the baseline $path cannot be read: ${reason(bad)}", bad)
        }
        require(lines.firstOrNull() == HEAD) { "$path is no baseline: its first line is not '$HEAD'" }
        return lines.drop(1).associate { line ->
            val (scene, words) = line.split(',').takeIf { it.size == 2 } ?: listOf(line, "")
            val result = SceneResult.entries.firstOrNull { it.words == words }
            scene to requireNotNull(result) { "$path: '$line' is no scene and its result" }
        }
    }

    /** Writes the results of a run of [command]. */
    fun write(path: Path, command: String, results: Map<String, SceneResult>) {
        val facts = mapOf(
            "command" to command, "version" to "unknown", "corpus" to "${CorpusFiles.VERSION}",
            "date" to "${LocalDate.now()}", "processor" to processor(),
        )
        val lines = facts.map { "# ${it.key}=${it.value}" } + HEAD + results.map { "${it.key},${it.value.words}" }
        try {
            Files.write(path, lines)
        } catch (bad: IOException) {
            throw IOException("the baseline $path cannot be written: ${reason(bad)}", bad)
        }
    }

    /** The name of the processor, where Linux says it, otherwise its architecture. */
    private fun processor(): String = try {
        Files.readAllLines(Path.of("/proc/cpuinfo")).first { it.startsWith("model name") }.substringAfter(": ")
    } catch (_: Exception) {
        System.getProperty("os.arch")
    }
}
