package dev.lazyz.cli.input

import dev.lazyz.cli.output.printable
import dev.lazyz.scenes.SceneFormat
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.name

/**
 * The inputs that words of the command line name: the words themselves, with folders replaced by the files in them.
 */
internal class NamedInputs(private val words: List<String>, private val format: SceneFormat?) {
    /** Whether there is only one input that is not a folder. Commands then report in detail. */
    val isSingle: Boolean = words.size == 1 && !isFolder(words[0])

    /**
     * All inputs, in the order of the words. A folder is replaced by the model and scene files in it and in its
     * subfolders, sorted by path, character by character. Names that begin with a dot are skipped. A folder without
     * such files is kept as an input, and reading it then reports the error. Links to folders are not followed, as they
     * may form loops; links to files are.
     */
    val all: Sequence<String> = words.asSequence().flatMap { if (isFolder(it)) files(Path.of(it)) else listOf(it) }

    private fun isFolder(word: String): Boolean =
        word.isNotEmpty() && !Input(word, format).isBuiltin && Files.isDirectory(Path.of(word))

    private fun files(folder: Path): List<String> = folder.toFile().walkTopDown()
        .onEnter { it.toPath() == folder || (!it.name.startsWith('.') && !Files.isSymbolicLink(it.toPath())) }
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

    /**
     * Returns whether [file] is a scene file, not other JSON: its first bytes contain the key `lazyz`. Returns true for
     * an unreadable file, so that reading it later reports the error.
     */
    private fun isSceneFile(file: Path): Boolean = try {
        Files.newInputStream(file).use { "\"lazyz\"" in String(it.readNBytes(HEAD), Charsets.ISO_8859_1) }
    } catch (unreadable: IOException) {
        true
    }

    companion object {
        private const val HEAD = 4096

        /** Returns why [folder] cannot be read as one file of [format], or of any format if that is null. */
        fun problem(folder: String, format: SceneFormat?): String {
            val path = Path.of(folder)
            if (NamedInputs(emptyList(), format).files(path) != listOf("$path")) {
                return "${printable(folder)} is a folder, and this command takes one file"
            }
            val endings = (if (format == null) SceneFormat.entries else listOf(format)).flatMap { it.extensions }
            val names = endings.joinToString { ".$it" }
            return "${printable(folder)} has no models or scene files, whose names end in $names"
        }
    }
}
