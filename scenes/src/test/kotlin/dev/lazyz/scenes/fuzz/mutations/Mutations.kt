package dev.lazyz.scenes.fuzz.mutations

import java.util.Random

/** Ways to change a file a little. The same [Random] gives the same changes. Thread safe. */
internal fun interface Mutations {
    /** Returns a changed copy of [input], which may take parts of [other]; null if [input] is of another kind. */
    fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray?
}

internal fun <T> Random.pick(from: List<T>): T = from[nextInt(from.size)]

/** A number below [bound], mostly a small one. */
internal fun Random.small(bound: Int): Int = nextInt(nextInt(nextInt(bound) + 1) + 1)
