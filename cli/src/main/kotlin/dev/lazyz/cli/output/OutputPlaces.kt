package dev.lazyz.cli.output

import java.nio.file.Files
import java.nio.file.Path

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
