package dev.lazyz.scenes.obj.materials

import de.javagl.obj.MtlReader
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.Statements
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers
import dev.lazyz.world.material.Material
import java.io.BufferedReader
import java.io.IOException
import java.io.Reader
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

/**
 * The statements of a material library that give colours and numbers, one for each [readLine], for `MtlReader`. Texture
 * statements are stored in [maps] instead, because that parser takes the last word as the file name.
 *
 * If an entry has both `d` (opacity) and `Tr` (its opposite, not in the specification), `d` is used. `MtlReader` does
 * not report line numbers; [number] is the current line, also after `MtlReader` has failed.
 */
internal class MtlStatements(private val library: Source) : BufferedReader(Reader.nullReader()) {
    private val statements = Statements(library)

    /** For each `newmtl` so far, its texture statements by keyword. */
    val maps = ArrayList<Map<String, MtlMap>>()

    /** For each `newmtl` so far, whether it has a `d`. */
    val haveOpacity = ArrayList<Boolean>()

    /** For each `newmtl` so far, its numbers such as `pm`, as far as they are given. */
    val model = ArrayList<HashMap<String, Float>>()

    /** The statement that was returned last. */
    var statement = ""
        private set

    /** The first line of the statement that was read last, counted from 1. */
    val number: Int get() = statements.number

    /** Statements for features that are not rendered, except those that would change nothing. */
    val unused = KindCounts()

    private var current = HashMap<String, MtlMap>()

    override fun readLine(): String? {
        while (statements.next()) {
            val statement = statements.statement()
            if (statement.length > LONGEST) TextLines.tooLong(library, number, LONGEST)
            val keyword = statement.substringBefore(' ').lowercase()
            return prepared(keyword, statement) ?: continue
        }
        return null
    }

    /**
     * Returns [statement] in the form that the parser expects, or null to drop it. [keyword] is its first word in lower
     * case.
     */
    private fun prepared(keyword: String, statement: String): String? {
        if (keyword == "newmtl") {
            current = HashMap()
            maps.add(current)
            library.loading.items(library, 1)
            haveOpacity.add(false)
            model.add(HashMap())
        } else if (maps.isEmpty()) {
            return null
        }
        this.statement = statement
        return when (keyword) {
            // The parser accepts the keyword in lower case only
            "newmtl" -> "newmtl" + statement.substring(keyword.length)
            "d" -> numbers().also { haveOpacity[haveOpacity.size - 1] = true }
            "tr" -> numbers().takeUnless { haveOpacity.last() }
            "kd", "ks", "ke", "ns", "illum" -> numbers()
            "pm", "pr", "pc", "pcr", "ps", "aniso", "anisor" -> null.also { setModel(keyword) }
            in USED_MAPS -> null.also { current[keyword] = MtlMap.parse(statement.substring(keyword.length)) }
            else -> null.also { setUnused(keyword) }
        }
    }

    private fun setUnused(keyword: String) {
        val isTexture = keyword.startsWith("map_") || keyword in MAPS
        if (!isTexture && (keyword !in NEUTRAL || isNeutral(keyword))) return
        unused.add(keyword)
    }

    /** Returns whether all numbers of the statement are such that it changes nothing. */
    private fun isNeutral(keyword: String): Boolean =
        TextLines.words(statements.withoutComment()).drop(1).all { TextNumbers.parseFloat(it) == NEUTRAL[keyword] }

    private fun setModel(keyword: String) {
        val word = TextLines.words(statements.withoutComment()).getOrNull(1) ?: return
        val number = word.toFloatOrNull() ?: TextNumbers.parseFloat(word) ?: return
        if (number.isFinite()) model.last()[keyword] = number.coerceIn(0f, 1f)
    }

    /** Returns the statement with numbers rewritten if the parser does not accept their spelling. */
    private fun numbers(): String = TextLines.words(statements.withoutComment()).joinToString(" ") { word ->
        if (word.toFloatOrNull() != null) word else TextNumbers.parseFloat(word)?.toString() ?: word
    }

    private companion object {
        /** The longest statement, in characters: some names of files and some numbers. */
        const val LONGEST = 1 shl 14

        /** Keywords of the texture statements that are rendered. */
        val USED_MAPS = setOf("map_kd", "map_d", "map_ke", "map_bump", "bump", "norm", "map_pm", "map_pr")

        /** Keywords of other texture statements that do not begin with `map_`. */
        val MAPS = setOf("decal", "disp", "refl")

        /** Keywords of numbers that are not rendered, each with the number that changes nothing: transmitted light. */
        val NEUTRAL = mapOf("tf" to 1f)
    }
}
