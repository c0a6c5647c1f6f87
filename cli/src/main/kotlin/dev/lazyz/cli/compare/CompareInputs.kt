package dev.lazyz.cli.compare

import dev.lazyz.cli.input.Input
import dev.lazyz.scenes.SceneFormat
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.name

/** What the words of `zcli compare` stand for: inputs as they are, and the files that folders hold. */
internal class CompareInputs(private val words: List<String>, private val format: SceneFormat?) {
    /** Whether the words name but one input, whose comparison is told at length. */
    val isSingle: Boolean = words.size == 1 && !isFolder(words[0])

    /**
     * All inputs in the order of the words; in place of a folder, the model and scene files in it and in its folders, in
     * the order of their paths, character by character. What begins with a dot is left out. A folder without any such
     * file stands for itself, for the reader to complain.
     */
    val all: Sequence<String> = words.asSequence().flatMap { if (isFolder(it)) files(Path.of(it)) else listOf(it) }

    private fun isFolder(word: String): Boolean =
        word.isNotEmpty() && !Input(word, format).isBuiltin && Files.isDirectory(Path.of(word))

    private fun files(folder: Path): List<String> = folder.toFile().walkTopDown()
        .onEnter { it.toPath() == folder || !it.name.startsWith('.') }
        .map { it.toPath() }
        .filter { !it.name.startsWith('.') && Files.isRegularFile(it) && isWanted(it) }
        .map { it.invariantSeparatorsPathString }
        .sorted()
        .toList()
        .ifEmpty { listOf(folder.toString()) }

    private fun isWanted(file: Path): Boolean {
        val known = SceneFormat.ofFileName(file.name) ?: return false
        if (format != null && known != format) return false
        return known != SceneFormat.SCENE || isSceneFile(file)
    }

    /** JSON is used for much; a scene file says early what it is. What cannot be read is for the reader to tell. */
    private fun isSceneFile(file: Path): Boolean = try {
        Files.newInputStream(file).use { "\"lazyz\"" in String(it.readNBytes(HEAD), Charsets.ISO_8859_1) }
    } catch (unreadable: IOException) {
        true
    }

    private companion object {
        const val HEAD = 4096
    }
}
