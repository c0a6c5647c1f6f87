package dev.lazyz.conformance.fuzz

import dev.lazyz.conformance.cases.FrameCase
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE

/**
 * A folder with the results of fuzzing: `recipes.txt` has a line for each frame with a new pair of traits, and the
 * subfolder `differences` has the frames that two renderers rendered differently.
 *
 * @param folder created when something is written; if null, nothing is saved
 */
internal class Corpus(private val folder: Path?) {
    private val file = folder?.resolve("recipes.txt")

    /** Reads the recipes. Lines of other versions are ignored. */
    fun read(): List<Recipe> =
        if (file == null || !Files.exists(file)) emptyList() else Files.readAllLines(file).mapNotNull(Recipe::parse)

    /** Adds [recipe]. */
    fun add(recipe: Recipe) {
        if (file == null) return
        Files.createDirectories(file.parent)
        Files.writeString(file, "$recipe\n", CREATE, APPEND)
    }

    /**
     * Saves a frame that is rendered differently, with the [message], and as a scene file if that format can express
     * it.
     */
    fun addDifference(recipe: Recipe, case: FrameCase, message: String) {
        val differences = folder?.resolve("differences") ?: return
        Files.createDirectories(differences)
        val name = "%08x".format(recipe.hashCode())
        Files.writeString(differences.resolve("$name.txt"), "$recipe\n\n$message\n")
        case.sceneFile()?.let { Files.writeString(differences.resolve("$name.json"), it) }
    }
}
