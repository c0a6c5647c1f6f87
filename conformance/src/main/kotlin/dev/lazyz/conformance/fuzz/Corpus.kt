package dev.lazyz.conformance.fuzz

import dev.lazyz.conformance.cases.FrameCase
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE

/**
 * A folder of what fuzzing found: `recipes.txt`, a line for each frame that had a pair of traits that none had before,
 * and a folder `differences` with the frames that two renderers rendered differently.
 *
 * @param folder made when there is something to write; null keeps nothing
 */
internal class Corpus(private val folder: Path?) {
    private val file = folder?.resolve("recipes.txt")

    /** Reads the recipes; lines of other versions are left alone. */
    fun read(): List<Recipe> =
        if (file == null || !Files.exists(file)) emptyList() else Files.readAllLines(file).mapNotNull(Recipe::parse)

    /** Adds [recipe]. */
    fun add(recipe: Recipe) {
        if (file == null) return
        Files.createDirectories(file.parent)
        Files.writeString(file, "$recipe\n", CREATE, APPEND)
    }

    /** Keeps a frame that is rendered differently, as [message] says; as a scene file too, if there are words for it. */
    fun addDifference(recipe: Recipe, case: FrameCase, message: String) {
        val differences = folder?.resolve("differences") ?: return
        Files.createDirectories(differences)
        val name = "%08x".format(recipe.hashCode())
        Files.writeString(differences.resolve("$name.txt"), "$recipe\n\n$message\n")
        case.sceneFile()?.let { Files.writeString(differences.resolve("$name.json"), it) }
    }
}
