package dev.lazyz.conformance.fuzz

import dev.lazyz.Capability
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.results.counted
import dev.lazyz.conformance.run.smallest
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.time.Duration
import java.util.Locale
import java.util.Random
import net.jqwik.api.sessions.JqwikSession

/**
 * Searches for frames that two renderers render differently, without an oracle, so that frames of any size and runs of
 * any duration are possible.
 *
 * The search is guided by the traits of frames: frames with a new pair of traits are kept, in a corpus on disk if there
 * is one, and are varied to create others. If one of the renderers does not blend, translucent frames are rendered as
 * opaque ones. Frames that differ are shrunk.
 *
 * Not thread safe. Uses jqwik's generators, so do not use jqwik otherwise in this thread during a run.
 *
 * @param expected the renderer that is assumed to be correct
 * @param actual the other renderer
 */
public class DifferentialFuzzing(private val expected: Renderer, private val actual: Renderer) {
    private var time: Duration = Duration.ofMinutes(1)
    private var mostFrames = Long.MAX_VALUE
    private var corpus = Corpus(null)
    private var random = Random(FIXED_SEED)
    private val pairs = TraitPairs()
    private val pool = ArrayList<Known>()

    /** Sets the duration of the run; by default a minute. */
    public fun time(time: Duration): DifferentialFuzzing = apply { this.time = time }

    /** Ends the run after [frames] frames, unless the time is over sooner. */
    public fun frames(frames: Long): DifferentialFuzzing = apply { mostFrames = frames }

    /** Saves results in [folder], and begins with the results of earlier runs. */
    public fun corpus(folder: Path): DifferentialFuzzing = apply { corpus = Corpus(folder) }

    /** Sets the seed, to choose other frames. */
    public fun seed(seed: Long): DifferentialFuzzing = apply { random = Random(seed) }

    /**
     * Renders frames until the time is over, or [MOST_DIFFERENCES] of them differ.
     *
     * @throws IOException if the corpus cannot be read or written
     */
    @Throws(IOException::class)
    public fun run(): DifferentialReport {
        val start = System.nanoTime()
        val known = ArrayDeque(corpus.read())
        val remembered = known.size
        val differences = ArrayList<String>()
        var frames = 0L
        while (frames < mostFrames && differences.size < MOST_DIFFERENCES &&
            System.nanoTime() - start < time.toNanos()
        ) {
            val old = known.removeFirstOrNull()
            val recipe = old ?: next()
            JqwikSession.run { difference(recipe, isNew = old == null)?.let { differences.add(it) } }
            frames++
        }
        val milliseconds = (System.nanoTime() - start) / NANOSECONDS
        return DifferentialReport(
            expected.id, actual.id, frames, minOf(remembered.toLong(), frames), pairs.size, differences, milliseconds,
        )
    }

    /** Returns a variation of a rare recipe, or a new one. */
    private fun next(): Recipe {
        while (true) {
            val recipe = if (pool.isEmpty() || random.nextInt(NEW) == 0) Recipe.any(random) else rare().changed(random)
            if (recipe.cost <= MOST_SAMPLES) return recipe
        }
    }

    /** Returns the recipe with the rarest traits among some known ones. */
    private fun rare(): Recipe =
        List(CANDIDATES) { pool[random.nextInt(pool.size)] }.maxBy { pairs.rarity(it.traits) }.recipe

    /**
     * Renders the frame of [recipe]. If the renderers differ, returns the difference for the smallest such frame that
     * was found; otherwise null.
     */
    private fun difference(recipe: Recipe, isNew: Boolean): String? {
        val frame = recipe.frame()
        val traits = recipe.traits(frame.value())
        if (pairs.add(traits) > 0) {
            pool.add(Known(recipe, traits))
            if (isNew) corpus.add(recipe)
        }
        val first = disagreement(recipe, frame.value()) ?: return null
        val (whole, disagreement) = smallest(frame, first, MOST_STEPS) { disagreement(recipe, it) }
        val case = rendered(recipe, whole)
        val who = "${expected.id} and ${actual.id} with ${recipe.options()}"
        val message = "$who: $disagreement\nin\n$case\nrecipe $recipe"
        corpus.addDifference(recipe, case, message)
        return message
    }

    /** Describes how the two renderers differ for [whole]; null if they do not. */
    private fun disagreement(recipe: Recipe, whole: FrameCase): String? {
        val case = rendered(recipe, whole)
        val (one, other) = listOf(expected, actual).map { renderer ->
            runCatching { Recording.of(renderer.configured(recipe.options().supportedBy(renderer)), case.frame) }
        }
        val thrown = listOf(one, other).map { it.exceptionOrNull()?.javaClass?.name }
        if (thrown[0] != thrown[1]) {
            return "the first threw ${thrown[0] ?: "nothing"}, the second ${thrown[1] ?: "nothing"}"
        }
        val images = listOf(one, other).map { it.getOrNull()?.image ?: return null }
        return difference(images[0], images[1])?.toString()
    }

    private fun rendered(recipe: Recipe, whole: FrameCase): FrameCase {
        val blend = listOf(expected, actual).all { Capability.TRANSPARENCY in it.capabilities }
        val case = recipe.finish(whole)
        return if (blend || !case.frame.hasTranslucency) case else case.asOpaque()
    }

    private class Known(val recipe: Recipe, val traits: Set<String>)

    public companion object {
        /** Number of frames that differ after which a run ends. */
        public const val MOST_DIFFERENCES: Int = 10

        private const val FIXED_SEED = 1995L
        private const val NANOSECONDS = 1_000_000L

        /** One in this number of frames is new instead of a variation. */
        private const val NEW = 4

        /** Number of recipes among which the rarest is varied. */
        private const val CANDIDATES = 8

        /** Greatest cost of a frame. Larger ones would take seconds with the slowest renderers. */
        private const val MOST_SAMPLES = 3_000_000L

        /** Greatest number of smaller frames to render when shrinking a frame. */
        private const val MOST_STEPS = 300
    }
}

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

/**
 * The result of comparing two renderers on many frames. Immutable and thread safe.
 *
 * @property expected id of the renderer that is assumed to be correct
 * @property actual id of the other renderer
 * @property frames number of frames that both rendered
 * @property remembered number of frames from the corpus among them
 * @property pairs number of pairs of traits that occurred
 * @property differences for each frame that differs: the first sample, both values, the frame as code, its recipe
 * @property milliseconds duration
 */
public class DifferentialReport internal constructor(
    public val expected: String,
    public val actual: String,
    public val frames: Long,
    public val remembered: Long,
    public val pairs: Int,
    public val differences: List<String>,
    public val milliseconds: Long,
) {
    /** Whether all pictures are equal. */
    public val isEqual: Boolean get() = differences.isEmpty()

    /** Returns a summary for people. */
    public fun toText(): String = buildString {
        for (difference in differences) append(difference).append("\n\n")
        val verdict = when (differences.size) {
            0 -> "no picture differs"
            1 -> "1 picture differs"
            else -> "${differences.size} pictures differ"
        }
        append("$actual against $expected: ${counted(frames, "frame")}, $remembered of them from the corpus, ")
        append("${counted(pairs.toLong(), "pair")} of traits; $verdict; ")
        append("%.1f s\n".format(Locale.ROOT, milliseconds / 1000.0))
    }

    override fun toString(): String = "DifferentialReport($actual against $expected, $frames frames, " +
        "${differences.size} differences)"
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
