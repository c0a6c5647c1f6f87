package dev.lazyz.scenes.loading

import dev.lazyz.scenes.ReferencePolicy
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Finds the files that a model refers to.
 *
 * A reference is resolved relative to a folder, with `/` or `\` as separator: first the exact name, then a name that
 * differs only in case (the first in alphabetical order). An absolute path, a drive letter or a URL refers to a place
 * on the author's machine. Such a path is used if it lies within the folder; otherwise the file with the same name in
 * the folder is used. Only regular files count. Nothing is ever fetched from a network.
 *
 * @param folder the folder to search, or null for a stream, which has no folder
 * @param root the folder that must contain the file, symbolic links resolved, if the [policy] requires it
 * @param known where files that are found are added
 * @param look called before each search, which can take long; throws to end the reading
 */
internal class FileReferences(
    private val folder: Path?,
    private val root: Path?,
    private val policy: ReferencePolicy,
    private val known: MutableSet<Path> = HashSet(),
    private val look: () -> Unit = {},
) {
    /**
     * The result of a search.
     *
     * @property file the regular file that the reference names, or null
     * @property problem if there is no file, what is wrong: "is missing"
     * @property remedy if there is no file, what to do about it
     */
    class Found(val file: Path?, val problem: String = "", val remedy: String = "") {
        /** The text of a warning about a reference that is ignored. */
        val warning: String get() = "$problem and is left out; $remedy"
    }

    /** Searches for [reference] in [folders] in order, by default only in this object's folder. */
    fun find(reference: String, folders: List<Path> = listOfNotNull(folder)): Found {
        look()
        val files = folders.mapNotNull { resolve(it, reference) }
        val allowed = files.firstOrNull { isAllowed(it) }
        return when {
            allowed != null -> Found(allowed.also { known.add(it) })
            folders.isEmpty() -> Found(null, "cannot be looked up for a stream", "load from a file instead")
            files.isNotEmpty() -> Found(null, "lies outside $root", REMEDY)
            else -> Found(null, "is missing", "put it into ${place(folders.last(), reference)}")
        }
    }

    private fun isAllowed(file: Path): Boolean {
        if (policy == ReferencePolicy.ANYWHERE) return true
        return try {
            root != null && file.toRealPath().startsWith(root.toRealPath())
        } catch (_: IOException) {
            false
        }
    }

    /** Returns the folder in which the file of [reference] is searched: [folder], or one in it. */
    private fun place(folder: Path, reference: String): Path {
        val name = plain(reference)
        val parts = name.substringBeforeLast('/', "")
        if (parts.isEmpty() || isAbsolute(name)) return folder
        return try {
            val place = folder.resolve(parts).normalize()
            if (policy == ReferencePolicy.ANYWHERE || place.startsWith(folder.normalize())) place else folder
        } catch (_: InvalidPathException) {
            folder
        }
    }

    private fun plain(reference: String): String = reference.trim().removeSurrounding("\"").replace('\\', '/')

    private fun resolve(folder: Path, reference: String): Path? {
        val name = plain(reference)
        return try {
            if (isAbsolute(name)) {
                inside(folder, name) ?: lookUp(folder, name.substringAfterLast('/'))
            } else {
                lookUp(folder, name)
            }
        } catch (_: InvalidPathException) {
            null
        } catch (_: IOException) {
            null
        }
    }

    private fun isAbsolute(name: String) = name.startsWith("/") || scheme(name).isNotEmpty()

    /** Returns the letter of a drive, or the scheme of a URL, which is longer; empty if [name] has neither. */
    private fun scheme(name: String): String {
        val scheme = name.substringBefore(":/", "")
        val isOne = scheme.all { it in 'a'..'z' || it in 'A'..'Z' || it in '0'..'9' || it in "+.-" }
        return if (isOne && scheme.firstOrNull()?.isLetter() == true) scheme else ""
    }

    private fun inside(folder: Path, name: String): Path? {
        if (scheme(name).length > 1) return null
        val root = folder.toAbsolutePath().normalize()
        val file = Path.of(name).normalize()
        return file.takeIf { it.isAbsolute && it.startsWith(root) && Files.isRegularFile(it) }
    }

    private fun lookUp(folder: Path, name: String): Path? {
        // Resolve part by part, so that `.` and empty parts are skipped and each part can differ in case
        var place = folder.toAbsolutePath().normalize()
        for (part in name.split('/')) {
            place = when (part) {
                "", "." -> place
                ".." -> place.parent ?: return null
                else -> place.resolve(part).takeIf { Files.exists(it) } ?: otherCase(place, part) ?: return null
            }
        }
        return place.takeIf { Files.isRegularFile(it) }
    }

    private fun otherCase(folder: Path, name: String): Path? {
        if (!Files.isDirectory(folder)) return null
        return Files.newDirectoryStream(folder).use { entries ->
            entries.filter { it.fileName.toString().equals(name, ignoreCase = true) }.minOrNull()
        }
    }

    companion object {
        /** Remedy for a reference that leads out of the model's folder. */
        const val REMEDY: String =
            "copy it there, or if the model can be trusted set LoadLimits.references (zcli: --allow-outside)"

        /** Maximum size of a file, because it must fit into an array. */
        private const val MAX_BYTES = Int.MAX_VALUE - 8L

        /** Returns the whole content of [file], or null if it cannot be read or is too large for an array. */
        fun read(file: Path): ByteArray? = try {
            if (Files.size(file) > MAX_BYTES) null else Files.readAllBytes(file)
        } catch (_: IOException) {
            null
        }
    }
}
