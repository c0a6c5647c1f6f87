package dev.lazyz.cli.input

import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.printable
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.text.EditDistance
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.name

/**
 * The input that INPUT names: a built-in scene, a file, or standard input.
 *
 * The name of a built-in scene means that scene, even if there is a file of that name. With `./teapot`, or with
 * `--format`, the word means the file.
 */
internal class Input(
    private val word: String,
    private val format: SceneFormat?,
    private val options: LoadOptions = LoadOptions(),
) {
    val isStandardInput = word == "-"
    private val builtin = if (format == null) Scenes.builtins.firstOrNull { it.id == word } else null

    val isBuiltin: Boolean get() = builtin != null

    /** The file, or null if the input is none. */
    val file: Path? get() = if (isStandardInput || isBuiltin || word.isEmpty()) null else Path.of(word)

    /** The format that the user or the name says; null for built-in scenes, and if the content decides. */
    val statedFormat: SceneFormat? = if (isBuiltin) null else format ?: SceneFormat.ofFileName(word)

    /** The size of the file; null if the input is none, or there is no such file. */
    val fileBytes: Long? get() = file?.takeIf { Files.isRegularFile(it) }?.let { Files.size(it) }

    /** The name of the input in messages. */
    val name: String get() = if (isStandardInput) "standard input" else word

    /** The name on one line. */
    private val shown: String get() = printable(name)

    /** The name of the input without folder and extension, or null if it has none. */
    val baseName: String?
        get() = when {
            isStandardInput -> null
            builtin != null -> word
            else -> Path.of(word).fileName?.toString()?.substringBeforeLast('.')?.ifEmpty { null }
        }

    /** The folder of the input as its name says, or `.` if that says none. */
    val folder: String get() = file?.parent?.toString() ?: "."

    /** Reads the scene. Reports mistakes in the name before it reads anything. */
    fun load(streams: Streams): LoadedScene {
        if (isStandardInput) {
            val known = format ?: throw Mistake("specify the format of standard input with --format $FORMATS")
            return Scenes.load(streams.input, known, name, null, options)
        }
        if (builtin != null) return LoadedScene(builtin.scene(), emptyList(), builtin.size)
        val path = existingFile()
        return if (format != null) Scenes.load(path, format, options) else Scenes.load(path, options)
    }

    /** Opens the scene to be read part by part, with temporary files in [spool]. */
    fun stream(streams: Streams, spool: Path): StreamedScene {
        if (isStandardInput) {
            val known = format ?: throw Mistake("specify the format of standard input with --format $FORMATS")
            streams.remark("standard input is copied to a temporary file in $spool, because it is read more than once")
            return Scenes.stream(streams.input, known, name, options.limits, spool)
        }
        if (builtin != null) throw Mistake("--stream is for files and standard input, and $word is a built-in scene")
        return Scenes.stream(existingFile(), statedFormat, options.limits, spool)
    }

    /** Reports mistakes in the name, without reading anything. */
    fun requireNamed() {
        if (!isStandardInput && !isBuiltin) existingFile()
    }

    /** Returns the file that the input names. It exists, and its format is known from its extension or its content. */
    private fun existingFile(): Path {
        val path = Path.of(word)
        requireFile(path)

        // Without an extension, the first bytes determine the format. An unknown extension is a mistake
        val ending = path.fileName.toString().substringAfterLast('.', "")
        if (format != null || ending.isEmpty() || SceneFormat.ofFileName(word) != null) return path
        val unknown = "'.${printable(ending)}' of $shown is not a known extension"
        throw Mistake("$unknown; specify the format with --format $FORMATS")
    }

    private fun requireFile(path: Path) {
        val isThere = word.isNotEmpty() && Files.exists(path)
        if (isThere && Files.isDirectory(path)) throw Mistake(NamedInputs.problem(word, format))
        if (!isThere) {
            if (format != null || SceneFormat.ofFileName(word) != null) {
                val isScene = format != null && Scenes.builtins.any { it.id == word }
                val rule = if (isScene) "; with --format, INPUT is always a file" else ""
                throw Mistake("$shown: no such file$rule")
            }
            val hint = when {
                word.isNotEmpty() && word.all { it.isDigit() } -> "; a size is one word, such as --size 800x600"
                path.toString().endsWith(".png", ignoreCase = true) -> "; is it the output? Then write -o $shown"
                else -> EditDistance.hint(word, Scenes.builtins.map { it.id })
            }
            throw Mistake("there is no built-in scene and no file '$shown'$hint\nSee 'zcli scenes'.")
        }
        if (!Files.isRegularFile(path)) {
            throw Mistake(
                "$shown is a pipe or a device; send it to standard input, with --format: zcli ... - < $shown",
            )
        }
        if (!Files.isReadable(path)) throw Mistake("$shown: permission denied")
    }

    private companion object {
        val FORMATS = SceneFormat.entries.joinToString("|") { it.id }
    }
}

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
