package dev.lazyz.conformance

/** What a frame may have that makes it worth trying, for [Distribution]. */
public enum class FrameTrait(internal val words: String) {
    /** There are no primitives. */
    NO_PRIMITIVES("no primitives"),

    /** Every sample shows the background. */
    NOTHING_VISIBLE("nothing is visible"),

    /** Two primitives or more are visible. */
    SEVERAL_VISIBLE("several primitives are visible"),

    /** At some sample two primitives have the same, winning depth. */
    TIE("a tie at the winning depth"),

    /** At some sample a primitive is hidden by another or by the background. */
    HIDDEN("something is hidden"),

    /** Of two primitives each is before the other somewhere. */
    CROSSING("two primitives cross"),

    /** Only a part of the raster is asked for. */
    REGION("a region"),

    /** Some primitive is translucent. */
    TRANSLUCENT("translucency"),

    /** Some primitive's depth is no linear form. */
    FORMLESS("depth without a linear form"),

    /** The raster has one row or one column. */
    NARROW("one row or one column"),
}

/**
 * How many of the frames that rules were tried on have which trait: a run that never met a tie proves nothing about
 * ties. Immutable and thread safe.
 *
 * A frame that a rule renders in several ways counts once a try. Frames too large to look at count as frames only.
 *
 * @property frames number of frames
 * @property unexamined of them, number of those that were not looked at
 */
public class Distribution internal constructor(
    public val frames: Long,
    public val unexamined: Long,
    private val counts: Map<FrameTrait, Long>,
) {
    /** Returns the number of frames that have [trait]. */
    public fun count(trait: FrameTrait): Long = counts[trait] ?: 0

    internal operator fun plus(other: Distribution): Distribution = Distribution(
        frames + other.frames,
        unexamined + other.unexamined,
        FrameTrait.entries.associateWith { count(it) + other.count(it) },
    )

    override fun equals(other: Any?): Boolean = other is Distribution && frames == other.frames &&
        unexamined == other.unexamined && FrameTrait.entries.all { count(it) == other.count(it) }

    override fun hashCode(): Int = frames.hashCode() * 31 + FrameTrait.entries.map { count(it) }.hashCode()

    override fun toString(): String =
        "$frames frames (${FrameTrait.entries.joinToString { "${it.words}: ${count(it)}" }})"

    internal companion object {
        val NONE = Distribution(0, 0, emptyMap())
    }
}
