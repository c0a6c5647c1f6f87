package dev.lazyz.cli.output

import dev.lazyz.scenes.text.EditDistance
import java.io.IOException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name

/** Checks of a file before it is written, so that a mistake is reported before the work begins. */
internal object OutputFile {
    /**
     * Checks that [path], which is the value of [option], ends in one of [endings], and can be written.
     *
     * @param alternative what the message offers besides the endings
     * @throws Mistake otherwise
     */
    fun check(path: Path, option: String, endings: List<String>, alternative: String = "") {
        requireEnding(path, option, endings, alternative)
        requirePlace(path)
    }

    /**
     * Checks that no file of the command line would be replaced by another.
     *
     * @param files the files, each with its option
     * @throws Mistake if two of them are the same
     */
    fun requireDistinct(files: List<Pair<String, Path>>) {
        for ((i, first) in files.withIndex()) {
            val second = files.drop(i + 1).firstOrNull { isSame(it.second, first.second) } ?: continue
            if (first.first == second.first) throw Mistake("${first.first} is given twice")
            throw Mistake("${first.first} and ${second.first} must be different files: ${second.second}")
        }
    }

    private fun isSame(first: Path, second: Path): Boolean =
        if (Files.exists(first) && Files.exists(second)) {
            Files.isSameFile(first, second)
        } else {
            first.toAbsolutePath().normalize() == second.toAbsolutePath().normalize()
        }

    /**
     * Checks that [path], the value of [option], ends in one of [endings].
     *
     * @param alternative what the message offers besides the endings
     * @throws Mistake otherwise
     */
    fun requireEnding(path: Path, option: String, endings: List<String>, alternative: String = "") {
        val name = path.fileName?.toString().orEmpty()
        if (endings.none { name.endsWith(it, ignoreCase = true) && name.length > it.length }) {
            throw Mistake("$option must end in ${endings.joinToString(" or ")}$alternative: $path")
        }
    }

    /**
     * Creates the folder of [path] if there is none.
     *
     * @throws Mistake if this is not possible
     */
    fun createFolder(path: Path) {
        val folder = path.toAbsolutePath().parent ?: return
        try {
            Files.createDirectories(folder)
        } catch (failure: IOException) {
            val reason = (failure as? FileSystemException)?.reason?.let { ": $it" }.orEmpty()
            throw Mistake("cannot write $path: the folder $folder cannot be created$reason")
        }
    }

    /**
     * Checks that [path] can be written, if necessary after its folder is created.
     *
     * @throws Mistake otherwise
     */
    fun requireFolderOrPlaceForIt(path: Path) {
        var folder = path.toAbsolutePath().parent ?: path.toAbsolutePath()
        while (!Files.exists(folder)) {
            val parent = folder.parent ?: break
            if (folder.endsWith("..")) {
                throw Mistake("cannot write $path: there is no folder $parent, and '..' needs one that exists")
            }
            folder = parent
        }
        if (!Files.isDirectory(folder)) throw Mistake("cannot write $path: $folder is not a folder")
        requirePlaceIn(folder, path)
    }

    /**
     * Checks that [path] can be written, in a folder that exists.
     *
     * @throws Mistake otherwise
     */
    fun requirePlace(path: Path) {
        val folder = path.toAbsolutePath().parent
        if (!Files.isDirectory(path) && !Files.isDirectory(folder)) {
            throw Mistake("cannot write $path: there is no folder $folder")
        }
        requirePlaceIn(folder, path)
    }

    private fun requirePlaceIn(folder: Path, path: Path) {
        if (Files.isDirectory(path)) throw Mistake("cannot write $path: it is a folder")
        if (Files.isWritable(folder)) return
        val isReadOnly = Files.getFileStore(folder).isReadOnly
        val reason = if (isReadOnly) "the file system of $folder is read-only" else "no permission to write in $folder"
        throw Mistake("cannot write $path: $reason; choose another folder")
    }
}

/**
 * The existing files and folders that a command will replace, so that it does not replace what it reads.
 *
 * @param outputs the files that the command writes, and folders that it writes as a whole, each with its option
 */
internal class OutputPlaces(outputs: Iterable<Pair<String, Path>>) {
    /** Options by the real paths of their files and folders. */
    private val options: Map<Path, String> = outputs
        .filter { (_, path) -> Files.isRegularFile(path) || Files.isDirectory(path) }
        .associate { (option, path) -> path.toRealPath() to option }

    /**
     * Checks that none of the files [read] would be replaced.
     *
     * @param what what these files are, in the message
     * @throws Mistake otherwise
     */
    fun requireNone(read: Iterable<Path>, what: String) {
        for (file in read) {
            val option = if (Files.isRegularFile(file)) optionOf(file.toRealPath()) else null
            if (option != null) throw Mistake("$option would replace $what: $file; write to another file")
        }
    }

    /** Returns the option whose output is, or has in it, the file at the real path [real], or null. */
    private fun optionOf(real: Path): String? {
        var place: Path? = real
        while (place != null) {
            options[place]?.let { return it }
            place = place.parent
        }
        return null
    }
}

/**
 * Where a report goes, by the value [path] of [option]: a page `NAME.html` alone, or a folder, in which the page is
 * `report.html`. A folder that does not exist has no extension.
 *
 * @throws Mistake if it is neither, or cannot be written
 */
internal class ReportPlace(path: Path, option: String) {
    private val extension = path.name.drop(1).substringAfterLast('.', "")

    /** The folder, or null if there is only the page. */
    val folder: Path? = path.takeIf { Files.isDirectory(it) || !it.name.endsWith(HTML, ignoreCase = true) }

    val page: Path = folder?.resolve("report$HTML") ?: path

    init {
        // The end of a version, as in report-1.2, is no extension
        if (folder != null && !Files.isDirectory(folder) && extension.any { it.isLetter() }) {
            throw Mistake("$option must be a page, NAME$HTML, or a folder, whose name has no extension: $path")
        }
        if (folder == null) OutputFile.check(page, option, listOf(HTML)) else OutputFile.requireFolderOrPlaceForIt(page)
    }

    companion object {
        private const val HTML = ".html"

        /** The help text of options whose value is such a place. */
        const val HELP: String = "a page, NAME.html; or a folder, in which the page is report.html"
    }
}

/** What stands in braces in `-o`, and is replaced by something of the picture. */
internal enum class Placeholder {
    /** The folder of the input. */
    DIR,

    /** The name of the input without folder and extension. */
    STEM,

    /** The name of the input without folder. */
    NAME,

    /** The extension of the input, without a dot. */
    EXT,

    /** The side from which the picture is seen. */
    VIEW,

    /** The number of the input, from 1. */
    INDEX,

    /** The number of the step of a turntable, from 1. */
    FRAME,
    ;

    val word: String get() = "{${name.lowercase()}}"
}

/**
 * The name of a file with placeholders: `{stem}_{view}.png`. Two braces, `{{` or `}}`, stand for one.
 *
 * @throws Mistake if a placeholder is unknown, or a brace is not closed
 */
internal class OutputTemplate(val text: String) {
    /** Texts and placeholders, in their order. */
    private val parts: List<Any> = parse()

    /** The placeholders in it. */
    val placeholders: Set<Placeholder> = parts.filterIsInstance<Placeholder>().toSet()

    /** The name of the only file, or null if there are placeholders. */
    val name: String? get() = if (placeholders.isEmpty()) expand { it.word } else null

    /** Returns the name of a file; [value] returns what replaces a placeholder. */
    fun expand(value: (Placeholder) -> String): String =
        parts.joinToString("") { if (it is Placeholder) value(it) else it as String }

    private fun parse(): List<Any> {
        val found = ArrayList<Any>()
        var at = 0
        while (at < text.length) {
            val open = text.indexOf('{', at)
            found.add((if (open < 0) text.substring(at) else text.substring(at, open)).replace("}}", "}"))
            if (open < 0) break
            if (text.startsWith("{{", open)) {
                found.add("{")
                at = open + 2
                continue
            }
            val close = text.indexOf('}', open)
            if (close < 0) throw Mistake("-o: a brace is not closed: $text; write {{ for a brace in a name")
            found.add(placeholder(text.substring(open + 1, close)))
            at = close + 1
        }
        return found
    }

    private fun placeholder(word: String): Placeholder = known[word.lowercase()] ?: throw Mistake(
        "-o: unknown placeholder {$word}${EditDistance.hint(word, known.keys)}; known are " +
            Placeholder.entries.joinToString { it.word } + ", and {{ for a brace",
    )

    companion object {
        private val known = Placeholder.entries.associateBy { it.name.lowercase() }

        /** Returns the template without placeholders whose only file is [name]. */
        fun of(name: String): String = name.replace("{", "{{").replace("}}", "}}}}")
    }
}
