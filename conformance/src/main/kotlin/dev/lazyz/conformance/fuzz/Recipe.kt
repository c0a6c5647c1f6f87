package dev.lazyz.conformance.fuzz

import dev.lazyz.Coherence
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.frames.FrameKind
import dev.lazyz.conformance.frames.FrameMix
import dev.lazyz.conformance.frames.Frames
import java.util.Random
import net.jqwik.api.Shrinkable

/**
 * A frame and the options to render it with, as a line of text from which both are made again. Immutable.
 *
 * @property seed what is random in the frame
 */
internal class Recipe private constructor(private val chosen: Map<Ingredient, String>, val seed: Long) {
    /** What was chosen of [ingredient]. */
    operator fun get(ingredient: Ingredient): String = chosen.getValue(ingredient)

    private fun number(ingredient: Ingredient): Int = get(ingredient).toInt()

    /** Upper bound of the samples to look at, of all primitives together. */
    val cost: Long
        get() = 1L * number(Ingredient.WIDTH) * number(Ingredient.HEIGHT) *
            (number(Ingredient.PRIMITIVES) + number(Ingredient.LAYERS))

    /** Returns a recipe in which one ingredient, or only the seed, is another. */
    fun changed(random: Random): Recipe {
        val seed = random.nextLong()
        if (random.nextInt(SEED_ONLY) == 0) return Recipe(chosen, seed)
        val ingredient = Ingredient.entries[random.nextInt(Ingredient.entries.size)]
        return Recipe(chosen + (ingredient to any(ingredient, random)), seed)
    }

    /** The options that it says. */
    fun options(): RenderOptions = RenderOptions(
        Coherence.valueOf(get(Ingredient.COHERENCE)),
        get(Ingredient.MEMORY_BUDGET).toLongOrNull(),
        number(Ingredient.THREADS),
        number(Ingredient.TILE_SIZE),
    )

    /** The frame, which can be made smaller; [finish] makes what is rendered of it. */
    fun frame(): Shrinkable<FrameCase> {
        val kinds = listOf(Ingredient.KIND, Ingredient.SECOND_KIND).map { FrameKind.valueOf(get(it)) }
        val mix = FrameMix.of(*kinds.distinct().toTypedArray())
            .sized(number(Ingredient.WIDTH), number(Ingredient.HEIGHT))
            .counted(1, number(Ingredient.PRIMITIVES))
            .layered(number(Ingredient.LAYERS))
            .levels(number(Ingredient.LEVELS))
            .translucent(number(Ingredient.TRANSLUCENT))
        return Frames.of(mix).generator(GENERATOR_SIZE).next(Random(seed))
    }

    /** The part of [case] that is rendered. */
    fun finish(case: FrameCase): FrameCase = if (get(Ingredient.PART) == "WHOLE") case else case.withinAny(Random(seed))

    /** The line of text. */
    override fun toString(): String = chosen.entries.joinToString(" ") { "${it.key}=${it.value}" } + " SEED=$seed"

    override fun equals(other: Any?): Boolean = other is Recipe && chosen == other.chosen && seed == other.seed

    override fun hashCode(): Int = toString().hashCode()

    companion object {
        /** One change in so many is of the seed alone. */
        private const val SEED_ONLY = 3

        private const val GENERATOR_SIZE = 1000

        /** Returns a recipe of which everything is left to chance. */
        fun any(random: Random): Recipe =
            Recipe(Ingredient.entries.associateWith { any(it, random) }, random.nextLong())

        private fun any(ingredient: Ingredient, random: Random): String =
            ingredient.choices[random.nextInt(ingredient.choices.size)]

        /** Returns what [line] says, or null if it is no recipe of this version. */
        fun parse(line: String): Recipe? {
            val words = line.trim().split(' ').associate { it.substringBefore('=') to it.substringAfter('=', "") }
            val seed = words["SEED"]?.toLongOrNull() ?: return null
            val chosen = Ingredient.entries.associateWith { words[it.name] ?: return null }
            return if (chosen.all { (key, value) -> value in key.choices }) Recipe(chosen, seed) else null
        }
    }
}
