package dev.lazyz.conformance.census

/**
 * Counts sets of traits by the pairs that they contain. A single trait is counted as a pair with itself. Not thread
 * safe.
 */
internal class PairCounts {
    private val counts = LongArray(SIZE * SIZE)

    /** Counts a frame with the given [traits]. */
    fun add(traits: Set<FrameTrait>) {
        for (a in traits) for (b in traits) counts[a.ordinal * SIZE + b.ordinal]++
    }

    fun count(a: FrameTrait, b: FrameTrait): Long = counts[a.ordinal * SIZE + b.ordinal]

    operator fun plus(other: PairCounts): PairCounts {
        val sum = PairCounts()
        for (i in counts.indices) sum.counts[i] = counts[i] + other.counts[i]
        return sum
    }

    override fun equals(other: Any?): Boolean = other is PairCounts && counts.contentEquals(other.counts)

    override fun hashCode(): Int = counts.contentHashCode()

    private companion object {
        val SIZE = FrameTrait.entries.size
    }
}

/**
 * The number of tested frames by trait and by pair of traits. A run without a tie does not test ties, and a run without
 * a tie in a region does not test ties in regions. Immutable and thread safe.
 *
 * A frame that a rule renders in several ways counts once per try, with the traits of the first way. Of large frames
 * only some rows are examined, so that a trait of few samples may be missed. Frames that are too large for that count
 * as frames without traits.
 *
 * @property frames number of frames
 * @property unexamined number of frames that were not examined
 */
public class Distribution internal constructor(
    public val frames: Long,
    public val unexamined: Long,
    private val pairs: PairCounts,
) {
    /** Returns the number of frames that have [trait]. */
    public fun count(trait: FrameTrait): Long = pairs.count(trait, trait)

    /** Returns the number of frames that have both [one] and [other]. */
    public fun count(one: FrameTrait, other: FrameTrait): Long = pairs.count(one, other)

    internal operator fun plus(other: Distribution): Distribution =
        Distribution(frames + other.frames, unexamined + other.unexamined, pairs + other.pairs)

    override fun equals(other: Any?): Boolean = other is Distribution && frames == other.frames &&
        unexamined == other.unexamined && pairs == other.pairs

    override fun hashCode(): Int = frames.hashCode() * 31 + pairs.hashCode()

    override fun toString(): String =
        "$frames frames (${FrameTrait.entries.joinToString { "${it.words}: ${count(it)}" }})"

    internal companion object {
        val NONE = Distribution(0, 0, PairCounts())
    }
}
