package dev.lazyz.scenes.loading

import dev.lazyz.scenes.ReferencePolicy
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Finds the files that a model refers to.
 *
 * A reference is looked up relative to a folder, with `/` or `\` between its parts; the exact name first, then one that
 * differs in case only (the first in alphabetical order). An absolute path, a drive letter or a URL names a place on the
 * author's machine: it is used if it lies within the folder, and otherwise the file of the same name in the folder is.
 * Only regular files count. Nothing is ever fetched from a network.
 *
 * @param folder where to look, or null for a stream that has no place
 * @param root the folder that a file must lie in, links resolved, if the [policy] says so
 */
internal class FileReferences(
    private val folder: Path?,
    private val root: Path?,
    private val policy: ReferencePolicy,
) {
    /**
     * What came of a reference.
     *
     * @property file the regular file that it stands for, or null
     * @property problem if there is none, what is wrong: "is missing"
     * @property remedy and what to do about it
     */
    class Found(val file: Path?, val problem: String = "", val remedy: String = "") {
        /** What a warning says of a reference that is not followed. */
        val warning: String get() = "$problem and is left out; $remedy"
    }

    /** Looks for [reference] in [folders], by default the one folder, in order. */
    fun find(reference: String, folders: List<Path> = listOfNotNull(folder)): Found {
        val files = folders.mapNotNull { resolve(it, reference) }
        val allowed = files.firstOrNull { isAllowed(it) }
        return when {
            allowed != null -> Found(allowed)
            folders.isEmpty() -> Found(null, "cannot be looked up for a stream", "load from a file instead")
            files.isNotEmpty() -> Found(null, "lies outside $root", REMEDY)
            else -> Found(null, "is missing", "put it into ${folders.last()}")
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

    private fun resolve(folder: Path, reference: String): Path? {
        val name = reference.trim().removeSurrounding("\"").replace('\\', '/')
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

    private fun isAbsolute(name: String) = name.startsWith("/") || drive.matches(name) || url.matches(name)

    private fun inside(folder: Path, name: String): Path? {
        if (url.matches(name)) return null
        val root = folder.toAbsolutePath().normalize()
        val file = Path.of(name).normalize()
        return file.takeIf { it.isAbsolute && it.startsWith(root) && Files.isRegularFile(it) }
    }

    private fun lookUp(folder: Path, name: String): Path? {
        // Walk down the parts, so that `.` and empty parts fall out and each part may differ in case
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
        /** What to do about a reference that leads out of the model's folder. */
        private const val REMEDY =
            "copy it there, or if the model can be trusted set LoadLimits.references (zcli: --allow-outside)"

        /** Largest file that is read, for it has to fit an array. */
        private const val MAX_BYTES = Int.MAX_VALUE - 8L

        private val drive = Regex("[A-Za-z]:/.*")
        private val url = Regex("[A-Za-z][A-Za-z0-9+.-]+:/.*")

        /** Returns the whole content of [file], or null if it cannot be read or is too large for an array. */
        fun read(file: Path): ByteArray? = try {
            if (Files.size(file) > MAX_BYTES) null else Files.readAllBytes(file)
        } catch (_: IOException) {
            null
        }
    }
}
