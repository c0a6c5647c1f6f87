package dev.lazyz.conformance.fuzz

import dev.lazyz.conformance.cases.FrameCase
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE

/**
 * A folder with the results of fuzzing: `recipes.txt` has a line for each frame that is kept, and the
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
     * Saves the [message] about a frame that is rendered differently, and [cases], this frame with those before it, as
     * scene files where that format can express them.
     */
    fun addDifference(recipe: Recipe, cases: List<FrameCase>, message: String) {
        val differences = folder?.resolve("differences") ?: return
        Files.createDirectories(differences)
        val name = "%08x".format(recipe.hashCode())
        Files.writeString(differences.resolve("$name.txt"), "$recipe\n\n$message\n")
        for ((i, case) in cases.withIndex()) {
            val number = if (i == cases.lastIndex) "" else "-${i + 1}"
            case.sceneFile()?.let { Files.writeString(differences.resolve("$name$number.json"), it) }
        }
    }
}

/**
 * Counts how often two traits occurred in the same frame, to guide fuzzing to new kinds of frames.
 *
 * A trait is a word, such as `TIE` or `WIDTH=65`. Not thread safe.
 */
internal class TraitPairs {
    private val counts = HashMap<Pair<String, String>, Int>()

    /** Number of different pairs that occurred. */
    val size: Int get() = counts.size

    /** Counts the pairs of a frame's [traits], and returns how many of them are new. */
    fun add(traits: Set<String>): Int {
        var new = 0
        forEach(traits) { pair -> if (counts.merge(pair, 1, Int::plus) == 1) new++ }
        return new
    }

    /** Returns how rare the pairs of [traits] are: the sum of the reciprocals of their counts. */
    fun rarity(traits: Set<String>): Double {
        var sum = 0.0
        forEach(traits) { pair -> sum += 1.0 / counts.getOrDefault(pair, 1) }
        return sum
    }

    private inline fun forEach(traits: Set<String>, block: (Pair<String, String>) -> Unit) {
        val sorted = traits.sorted()
        for (i in sorted.indices) {
            for (j in i + 1 until sorted.size) block(sorted[i] to sorted[j])
        }
    }
}
