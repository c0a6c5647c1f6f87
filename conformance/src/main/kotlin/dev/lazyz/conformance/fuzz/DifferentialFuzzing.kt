package dev.lazyz.conformance.fuzz

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.results.counted
import java.io.IOException
import java.nio.file.Path
import java.time.Duration
import java.util.Locale
import java.util.Random
import java.util.function.Supplier
import net.jqwik.api.sessions.JqwikSession

/**
 * Searches for frames that two renderers render differently, without an oracle, so that frames of any size and runs of
 * any duration are possible.
 *
 * The search is guided by the traits of frames and, if Java was started with JaCoCo's agent, by the code that the
 * second renderer reaches: frames with a new pair of traits, and frames that reach new code, are kept, in a corpus on
 * disk if there is one, and are varied to create others. If one of the renderers does not blend, translucent frames are
 * rendered as opaque ones. The same renderers render many frames, one after the other. Frames that differ are shrunk,
 * with those frames before them that it takes.
 *
 * Not thread safe. Uses jqwik's generators, so do not use jqwik otherwise in this thread during a run.
 *
 * @param expected returns a new renderer that is assumed to be correct
 * @param actual returns a new one of the other renderer
 */
public class DifferentialFuzzing(
    private val expected: Supplier<out Renderer>,
    private val actual: Supplier<out Renderer>,
) {
    private val both = listOf(expected.get(), actual.get())
    private var time: Duration = Duration.ofMinutes(1)
    private var mostFrames = Long.MAX_VALUE
    private var corpus = Corpus(null)
    private var random = Random(FIXED_SEED)
    private var probes = AgentProbes.find()
    private var isGuided = true
    private var mostSamples = MOST_SAMPLES
    private val pairs = TraitPairs()
    private val pool = ArrayList<Known>()
    private val reaching = ArrayList<Recipe>()
    private val inUse = HashMap<String, InUse>()

    /** Sets the duration of the run; by default a minute. */
    public fun time(time: Duration): DifferentialFuzzing = apply { this.time = time }

    /** Ends the run after [frames] frames, unless the time is over sooner. */
    public fun frames(frames: Long): DifferentialFuzzing = apply { mostFrames = frames }

    /** Saves results in [folder], and begins with the results of earlier runs. */
    public fun corpus(folder: Path): DifferentialFuzzing = apply { corpus = Corpus(folder) }

    /** Sets the seed, to choose other frames. */
    public fun seed(seed: Long): DifferentialFuzzing = apply { random = Random(seed) }

    /** Counts [probes], and lets them guide the search only if [isGuided]. */
    internal fun probes(probes: Probes?, isGuided: Boolean) = apply {
        this.probes = probes
        this.isGuided = isGuided
    }

    /** Sets the greatest number of samples times primitives of a frame. */
    internal fun mostSamples(samples: Long) = apply { mostSamples = samples }

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
            both[0].id, both[1].id, frames, minOf(remembered.toLong(), frames), pairs.size, probes?.reached,
            differences, milliseconds,
        )
    }

    /** Returns a variation of a recipe that reached new code, or of a rare one, or a new one. */
    private fun next(): Recipe {
        while (true) {
            val recipe = when {
                pool.isEmpty() || random.nextInt(NEW) == 0 -> Recipe.any(random)
                reaching.isNotEmpty() && random.nextBoolean() -> recent().varied(random)
                else -> rare().changed(random)
            }
            if (recipe.cost <= mostSamples) return recipe
        }
    }

    /** Returns the recipe with the rarest traits among some known ones. */
    private fun rare(): Recipe =
        List(CANDIDATES) { pool[random.nextInt(pool.size)] }.maxBy { pairs.rarity(it.traits) }.recipe

    /** Returns a recipe that reached new code, rather a new one. */
    private fun recent(): Recipe {
        val newest = if (random.nextBoolean()) minOf(reaching.size, NEWEST) else reaching.size
        return reaching[reaching.size - 1 - random.nextInt(newest)]
    }

    /**
     * Renders the frame of [recipe]. If the renderers differ, returns the difference for the smallest such frame that
     * was found; otherwise null.
     */
    private fun difference(recipe: Recipe, isNew: Boolean): String? {
        val whole = recipe.frame().value()
        val options = recipe.options().supportedBy(both[1])
        val used = inUse.compute("$options") { _, old ->
            old?.takeIf { it.recipes.size < MOST_EARLIER } ?: InUse(RendererPair(listOf(expected, actual), options))
        }!!
        used.recipes.add(recipe)
        val case = rendered(recipe, whole)
        val first = used.pair.disagreement(case) { probes?.forget() }
        keep(recipe, whole, isNew)
        if (first == null) return null
        inUse.remove("$options")
        val failure = reduced(used.recipes, options)
        val cases = failure?.cases ?: listOf(case)
        val where = when {
            failure == null -> ", but not again with the same frames\nin"
            cases.size == 1 -> "\nin"
            else -> "\nin the last of ${cases.size} frames that the same renderers render, one after the other:"
        }
        val who = "${both[0].id} and ${both[1].id} with $options"
        val message = "$who: ${failure?.why ?: first}$where\n${cases.joinToString("\n")}\nrecipe $recipe"
        corpus.addDifference(recipe, cases, message)
        return message
    }

    /** Keeps [recipe] if its frame, which was rendered, is a new kind of frame or reached new code. */
    private fun keep(recipe: Recipe, whole: FrameCase, isNew: Boolean) {
        val traits = recipe.traits(whole)
        val isRare = pairs.add(traits) > 0
        val reaches = (probes?.take() ?: 0) > 0 && isGuided
        if (isRare) pool.add(Known(recipe, traits))
        if (reaches) reaching.add(recipe)
        if ((isRare || reaches) && isNew) corpus.add(recipe)
    }

    private fun reduced(recipes: List<Recipe>, options: RenderOptions): Failure? {
        val frames = recipes.map { recipe -> recipe.frame().map { rendered(recipe, it) } }
        return reduced(frames, MOST_STEPS) { RendererPair(listOf(expected, actual), options).disagreement(it) }
    }

    private fun rendered(recipe: Recipe, whole: FrameCase): FrameCase {
        val blend = both.all { Capability.TRANSPARENCY in it.capabilities }
        val case = recipe.finish(whole)
        return if (blend || !case.frame.hasTranslucency) case else case.asOpaque()
    }

    private class Known(val recipe: Recipe, val traits: Set<String>)

    /** Renderers with the recipes of the frames that they have rendered. */
    private class InUse(val pair: RendererPair) {
        val recipes = ArrayList<Recipe>()
    }

    public companion object {
        /** Number of frames that differ after which a run ends. */
        public const val MOST_DIFFERENCES: Int = 10

        private const val FIXED_SEED = 1995L
        private const val NANOSECONDS = 1_000_000L

        /** One in this number of frames is new instead of a variation. */
        private const val NEW = 4

        /** Number of recipes among which the rarest is varied. */
        private const val CANDIDATES = 8

        /** Number of recipes that reached new code last, of which every other variation is one. */
        private const val NEWEST = 32

        /** Number of frames after which renderers are replaced by new ones. */
        private const val MOST_EARLIER = 64

        /** Greatest cost of a frame. Larger ones would take seconds with the slowest renderers. */
        private const val MOST_SAMPLES = 3_000_000L

        /** Greatest number of smaller frames to render when shrinking a frame. */
        private const val MOST_STEPS = 300
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
 * @property probes number of probes, branches of code, that the other renderer reached; null without JaCoCo's agent
 * @property differences for each frame that differs: the first sample, both values, the frame as code, its recipe
 * @property milliseconds duration
 */
public class DifferentialReport internal constructor(
    public val expected: String,
    public val actual: String,
    public val frames: Long,
    public val remembered: Long,
    public val pairs: Int,
    public val probes: Int?,
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
        append("${counted(pairs.toLong(), "pair")} of traits, ")
        append(probes?.let { counted(it.toLong(), "probe") } ?: "not guided by code: Java has no agent of JaCoCo")
        append("; $verdict; ")
        append("%.1f s\n".format(Locale.ROOT, milliseconds / 1000.0))
    }

    override fun toString(): String = "DifferentialReport($actual against $expected, $frames frames, " +
        "${differences.size} differences)"
}
