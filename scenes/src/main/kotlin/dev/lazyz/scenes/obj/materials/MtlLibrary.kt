package dev.lazyz.scenes.obj.materials

import de.javagl.obj.MtlReader
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.world.material.Material
import java.io.IOException
import java.nio.file.Path

/**
 * The materials of an OBJ file's libraries, by name (Alias|Wavefront, "MTL material format", version 4.2, 1995). If a
 * name is defined more than once, the first definition is used.
 *
 * A missing library, or a name that no library defines, gives a warning, and the material is plain white. Textures are
 * searched for first in the library's folder, then in the OBJ file's folder.
 */
internal class MtlLibrary(private val source: Source) {
    private val materials = HashMap<String, MtlMaterial>()

    /** The materials by their names without trailing comments. */
    private val uncommented = HashMap<String, MtlMaterial>()
    private val missing = HashMap<String?, MtlMaterial>()

    /**
     * Reads the libraries of an `mtllib` statement. [reference] is one file name, which may contain spaces, or several,
     * and may end with a comment.
     */
    fun add(reference: String) {
        for (name in names(reference)) {
            val found = source.references.find(name)
            if (found.file != null) read(found.file) else source.warn("material library ", name, " ${found.warning}")
        }
    }

    /**
     * Divides [reference] into names of files: the whole if there is such a file; otherwise behind each `.mtl`, and at
     * each space where that finds more.
     */
    private fun names(reference: String): List<String> {
        val plain = TextLines.uncommented(reference)
        for (whole in listOf(reference, plain)) if (isFile(whole)) return listOf(whole)
        return divided(plain).flatMap { name ->
            val words = TextLines.words(name)
            if (isFile(name) || words.none(::isFile)) listOf(name) else words
        }
    }

    /** Divides [names] behind each `.mtl` that a space follows. */
    private fun divided(names: String): List<String> {
        val parts = ArrayList<String>()
        var start = 0
        for (i in names.indices) {
            val isEnd = names[i].isWhitespace() && names.regionMatches(i - 4, ".mtl", 0, 4, ignoreCase = true)
            if (!isEnd) continue
            parts.add(names.substring(start, i).trim())
            start = i
        }
        return parts + names.substring(start).trim()
    }

    private fun isFile(name: String): Boolean = source.references.find(name).file != null

    /**
     * Returns the material with the given [name], which may end with a comment, or a plain white one if no library
     * defines it. If a name has a `#` after a space, the whole name is tried first.
     */
    fun material(name: String?): MtlMaterial {
        val plain = name?.let(TextLines::uncommented)
        return materials[name] ?: materials[plain] ?: uncommented[plain] ?: missing.getOrPut(name) {
            if (name != null) source.warn("material ", name, " is not defined in any library and becomes plain white")
            MtlMaterial(Material(name = name ?: ""), isDefined = false)
        }
    }

    private fun read(file: Path) {
        val bytes = FileReferences.read(file)
        if (bytes == null) {
            source.warn("material library ", "$file", " cannot be read; its materials are plain white")
            return
        }
        val library = Source(bytes, file.toString(), file.parent, source.loading)
        library.decodeText()
        val statements = MtlStatements(library)
        val entries = try {
            MtlReader.read(statements)
        } catch (e: SceneFormatException) {
            throw e
        } catch (e: IOException) {
            fail(file, statements, e)
        } catch (e: RuntimeException) {
            fail(file, statements, e)
        }
        val reader = MtlMaterials(source, listOfNotNull(file.parent, source.folder).distinct())
        for ((i, entry) in entries.withIndex()) {
            library.step()
            val material = materials.getOrPut(entry.name) {
                reader.material(entry, statements.maps[i], statements.haveOpacity[i], statements.model[i])
            }
            uncommented.putIfAbsent(TextLines.uncommented(entry.name), material)
        }
        if (statements.unused.total > 0) {
            val unused = "statements that are not used are ${statements.unused}"
            source.warn("material library ", "${file.fileName}", ": $unused")
        }
    }

    private fun fail(file: Path, statements: MtlStatements, cause: Exception): Nothing = throw SceneFormatException(
        file.toString(),
        "line ${statements.number}",
        "the statement \"${statements.statement}\" cannot be understood",
        "give it the numbers it needs, with decimal points and spaces between them, or remove it",
        cause,
    )
}
