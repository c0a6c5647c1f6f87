package dev.lazyz.conformance.fuzz

import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.PartSeeds
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.census.Census
import dev.lazyz.conformance.frames.FrameKind
import dev.lazyz.conformance.frames.FrameMix
import dev.lazyz.conformance.frames.Frames
import java.util.Random
import net.jqwik.api.Shrinkable

/**
 * A frame and the options to render it with, as a line of text from which both can be created again. Immutable.
 *
 * @property seed seed of what is not among the [parts]: camera, lights, order, region
 */
internal data class Recipe(
    private val chosen: Map<Ingredient, String>,
    private val seed: Long,
    private val parts: PartSeeds,
) {
    /** Returns the value of [ingredient]. */
    operator fun get(ingredient: Ingredient): String = chosen.getValue(ingredient)

    private fun number(ingredient: Ingredient): Int = get(ingredient).toInt()

    /** Upper bound of the number of samples times primitives. */
    val cost: Long
        get() = 1L * number(Ingredient.WIDTH) * number(Ingredient.HEIGHT) *
            (number(Ingredient.PRIMITIVES) + number(Ingredient.LAYERS))

    /** Returns a recipe with other seeds and, in most cases, another value of one ingredient. */
    fun changed(random: Random): Recipe =
        of(if (random.nextInt(SEEDS_ONLY) == 0) chosen else withAnother(random).chosen, random)

    /** Returns a recipe in which one or a few things are others, so that most of the frame stays as it is. */
    fun varied(random: Random): Recipe {
        var recipe = this
        do {
            recipe = when (random.nextInt(WAYS)) {
                0 -> recipe.withAnother(random)
                1 -> recipe.copy(seed = random.nextLong())
                2 -> recipe.copy(parts = recipe.parts.copy(raster = random.nextInt()))
                else -> recipe.copy(parts = recipe.parts.copy(groups = recipe.variedGroups(random)))
            }
        } while (random.nextBoolean())
        return recipe
    }

    private fun withAnother(random: Random): Recipe {
        val ingredient = Ingredient.entries[random.nextInt(Ingredient.entries.size)]
        return copy(chosen = chosen + (ingredient to any(ingredient, random)))
    }

    /** Returns the seeds of the groups with one of them new, moved or repeated, or with more or fewer of them. */
    private fun variedGroups(random: Random): List<Int> {
        val most = number(Ingredient.PRIMITIVES)
        val groups = parts.groups.toMutableList()
        val at = random.nextInt(groups.size)
        when (random.nextInt(WAYS)) {
            0 -> groups[at] = random.nextInt()
            1 -> groups.add(random.nextInt(groups.size), groups.removeAt(at))
            2 -> groups.add(at, groups[random.nextInt(groups.size)])
            3 -> groups.addAll(at, anyGroups(most, random))
            else -> groups.subList(at, random.nextInt(at, groups.size) + 1).clear()
        }
        return groups.take(most).ifEmpty { anyGroups(most, random) }
    }

    /** Returns the options of this recipe. */
    fun options(): RenderOptions = RenderOptions(
        Coherence.valueOf(get(Ingredient.COHERENCE)),
        get(Ingredient.MEMORY_BUDGET).toLongOrNull(),
        number(Ingredient.THREADS),
        number(Ingredient.TILE_SIZE),
    )

    /** Returns the frame, which can be shrunk. Apply [finish] before rendering. */
    fun frame(): Shrinkable<FrameCase> {
        val kinds = listOf(Ingredient.KIND, Ingredient.SECOND_KIND).map { FrameKind.valueOf(get(it)) }
        val mix = FrameMix.of(*kinds.distinct().toTypedArray())
            .sized(number(Ingredient.WIDTH), number(Ingredient.HEIGHT))
            .counted(1, number(Ingredient.PRIMITIVES))
            .layered(number(Ingredient.LAYERS))
            .levels(number(Ingredient.LEVELS))
            .translucent(number(Ingredient.TRANSLUCENT))
            .of(parts)
        return Frames.of(mix).generator(PartSeeds.GENERATOR_SIZE).next(Random(seed))
    }

    /** Returns the part of [case] to render. */
    fun finish(case: FrameCase): FrameCase = if (get(Ingredient.PART) == "WHOLE") case else case.withinAny(Random(seed))

    /** Returns the ingredients and the traits of the frame that was made from this recipe, as words. */
    fun traits(case: FrameCase): Set<String> {
        val chosen = Ingredient.entries.map { "$it=${get(it)}" }.toSet()
        val isSmall = case.frame.region.size * case.frame.primitives.size <= MOST_EXAMINED
        return if (isSmall) chosen + Census.traits(case.frame, case.scene).map { it.name } else chosen
    }

    /** Returns the line of text. */
    override fun toString(): String = chosen.entries.joinToString(" ", postfix = " ") { "${it.key}=${it.value}" } +
        "SEED=$seed RASTER=${parts.raster} GROUPS=${parts.groups.joinToString(",")}"

    companion object {
        /** One in this number of changes affects only the seeds. */
        private const val SEEDS_ONLY = 3

        /** Number of ways to vary a recipe, and its groups. */
        private const val WAYS = 5

        /**
         * Greatest number of samples times primitives to examine. Examining larger frames takes longer than rendering
         * them.
         */
        private const val MOST_EXAMINED = 300_000L

        /** Returns a random recipe. */
        fun any(random: Random): Recipe = of(Ingredient.entries.associateWith { any(it, random) }, random)

        /** Returns a recipe with random seeds. */
        private fun of(chosen: Map<Ingredient, String>, random: Random): Recipe {
            val groups = anyGroups(chosen.getValue(Ingredient.PRIMITIVES).toInt(), random)
            return Recipe(chosen, random.nextLong(), PartSeeds(random.nextInt(), groups))
        }

        /** Returns seeds of 1 to [most] groups; few are more frequent than many. */
        private fun anyGroups(most: Int, random: Random): List<Int> =
            List(1 + random.nextInt(1 + random.nextInt(most))) { random.nextInt() }

        private fun any(ingredient: Ingredient, random: Random): String =
            ingredient.choices[random.nextInt(ingredient.choices.size)]

        /** Parses [line]; returns null if it is not a recipe of this version. */
        fun parse(line: String): Recipe? {
            val words = line.trim().split(' ').associate { it.substringBefore('=') to it.substringAfter('=', "") }
            val chosen = Ingredient.entries.associateWith { words[it.name] ?: return null }
            val seed = words["SEED"]?.toLongOrNull() ?: return null
            val raster = words["RASTER"]?.toIntOrNull() ?: return null
            val groups = words["GROUPS"].orEmpty().split(',').map { it.toIntOrNull() ?: return null }
            val isKnown = chosen.all { (key, value) -> value in key.choices }
            return if (isKnown) Recipe(chosen, seed, PartSeeds(raster, groups)) else null
        }
    }
}

/** The parameters of a [Recipe] and their possible values. The names of both are stored in the corpus on disk. */
internal enum class Ingredient(val choices: List<String>) {
    /** The kind of at least half of the primitives. */
    KIND(FrameKind.entries.map { it.name }),

    /** The kind of the other primitives. */
    SECOND_KIND(FrameKind.entries.map { it.name }),

    /** Most columns: below and above the usual sizes of blocks and tiles. */
    WIDTH(listOf("1", "7", "20", "31", "65", "130", "257")),

    /** Most rows. */
    HEIGHT(listOf("1", "7", "20", "31", "65", "130", "257")),

    /** Most primitives in screen space, or surfaces in world space. */
    PRIMITIVES(listOf("3", "8", "30", "100", "400")),

    /** Number of polygons that cover the whole raster. */
    LAYERS(listOf("0", "0", "1", "9", "40")),

    /** Number of different depths of vertices; 0 for no limit. */
    LEVELS(listOf("0", "0", "1", "2", "5")),

    /** Percentage of frames with translucent primitives. */
    TRANSLUCENT(listOf("0", "100")),

    /** The whole raster, or a region of it. */
    PART(listOf("WHOLE", "REGION")),

    COHERENCE(Coherence.entries.map { it.name }),

    THREADS(listOf("1", "2", "5")),

    TILE_SIZE(listOf("8", "16", "64", "256")),

    /** Working memory in bytes. */
    MEMORY_BUDGET(listOf("NONE", "0", "1000", "100000")),
}
