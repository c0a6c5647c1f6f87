package dev.lazyz.conformance.cases

import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
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
