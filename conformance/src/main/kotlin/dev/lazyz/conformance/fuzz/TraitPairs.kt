package dev.lazyz.conformance.fuzz

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
