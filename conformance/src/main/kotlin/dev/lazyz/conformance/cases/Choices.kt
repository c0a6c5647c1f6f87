package dev.lazyz.conformance.cases

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import java.util.Random
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import net.jqwik.api.RandomDistribution
import net.jqwik.api.Tuple

/** Generates integers [from]..[to], all equally likely. */
internal fun ints(from: Int, to: Int): Arbitrary<Int> =
    Arbitraries.integers().between(from, to).withDistribution(RandomDistribution.uniform())

/** Generates one of [values], all equally likely. Shrinks to the first. */
internal fun <T : Any> oneOf(vararg values: T): Arbitrary<T> = ints(0, values.size - 1).map { values[it] }

/** Generates values of one of [choices]. The number of each pair is its weight. */
internal fun <T : Any> mixed(vararg choices: Pair<Int, Arbitrary<out T>>): Arbitrary<T> =
    Arbitraries.frequencyOf(*choices.map { Tuple.of<Int, Arbitrary<out T>>(it.first, it.second) }.toTypedArray())

/** Generates lists of at most [max] elements, rarely empty, all other lengths equally likely. */
internal fun <T : Any> listsOf(elements: Arbitrary<T>, max: Int): Arbitrary<List<T>> {
    val none = Arbitraries.just(emptyList<T>())
    if (max == 0) return none
    val some = elements.list().ofMinSize(1).ofMaxSize(max).withSizeDistribution(RandomDistribution.uniform())
    return mixed(1 to none, 15 to some)
}

/** Generates rasters. */
internal object Rasters {
    /**
     * Generates rasters of any shape, background, convention, depth test and background depth, with defaults in most
     * cases.
     */
    fun any(maxWidth: Int, maxHeight: Int): Arbitrary<Raster> {
        val backgrounds = oneOf(Rgba.WHITE, Rgba.TRANSPARENT, Rgba(0.25f, 0.5f, 0.125f, 0.75f))
        val conventions = oneOf(DepthConvention.SMALLER_IS_NEARER, DepthConvention.LARGER_IS_NEARER)
        return Combinators
            .combine(sides(maxWidth), sides(maxHeight), backgrounds, conventions, ints(0, 15), ints(0, 127))
            .`as` { width, height, background, convention, test, depth ->
                val depthTest = DepthTest.entries.getOrElse(test - 12) { convention.nearest }
                val behind = behindAll(depthTest)
                val fromBehind = BACKGROUND_DEPTHS.getOrElse(depth - 112) { 0 }
                val backgroundDepth = if (behind == 0) fromBehind else behind - fromBehind
                Raster(width, height, background, convention, depthTest, backgroundDepth)
            }
    }

    /** Returns the depth against which all fragments pass [test]: the default depth of a background. */
    fun behindAll(test: DepthTest): Int = when (test) {
        DepthTest.LESS, DepthTest.LESS_OR_EQUAL -> Int.MAX_VALUE
        DepthTest.GREATER, DepthTest.GREATER_OR_EQUAL -> 0
    }

    /**
     * Distances of a background from its default depth, in units: mostly in the middle, where it hides some primitives;
     * at the far plane; and where it hides nearly everything or everything.
     */
    private val BACKGROUND_DEPTHS =
        List(4) { listOf(Int.MAX_VALUE / 2, Int.MAX_VALUE / 2 + 1, Int.MAX_VALUE / 4 + it) }.flatten() +
            listOf(1, Depth.MARGIN, Int.MAX_VALUE - Depth.MARGIN, Int.MAX_VALUE)

    private fun sides(max: Int): Arbitrary<Int> {
        require(max in 1..Raster.MAX_SIDE) { "a side must be in 1..${Raster.MAX_SIDE}: $max" }
        return mixed(2 to ints(1, max), 13 to ints((max + 1) / 2, max), 1 to Arbitraries.just(1))
    }
}

/**
 * Seeds of parts of a frame, so that one part can be another one, and the others stay as they are. Frames still shrink.
 * Immutable.
 *
 * @property raster seed of the raster
 * @property groups a seed for each group of primitives on the screen, or surface in space; at least one
 */
internal data class PartSeeds(val raster: Int, val groups: List<Int>) {
    /** Generates one of [rasters], always the same. */
    fun rasters(rasters: Arbitrary<Raster>): Arbitrary<Raster> = seeded(rasters) { raster }

    /** Generates a list of [elements], always the same, that shrinks to shorter ones. */
    fun <T : Any> lists(elements: Arbitrary<T>): Arbitrary<List<T>> = Arbitraries.fromGenerator { random ->
        val seeds = groups.iterator()
        seeded(elements) { seeds.next() }.list().ofMinSize(1).ofMaxSize(groups.size).withSizeDistribution(ALL)
            .generator(GENERATOR_SIZE).next(random)
    }

    private fun <T : Any> seeded(values: Arbitrary<T>, seed: () -> Int): Arbitrary<T> {
        val generator = values.generator(GENERATOR_SIZE)
        return Arbitraries.fromGenerator { generator.next(Random(seed().toLong())) }
    }

    companion object {
        /** Number of tries for which generators are made. */
        const val GENERATOR_SIZE = 1000

        private val ALL = RandomDistribution { _, _, most, _ -> RandomDistribution.RandomNumericGenerator { most } }
    }
}
