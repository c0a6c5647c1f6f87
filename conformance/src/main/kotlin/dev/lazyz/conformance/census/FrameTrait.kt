package dev.lazyz.conformance.census

/** A property of a frame that is relevant for testing, see [Distribution]. */
public enum class FrameTrait(internal val words: String) {
    /** There are no primitives. */
    NO_PRIMITIVES("no primitives"),

    /** Every sample shows the background. */
    NOTHING_VISIBLE("nothing is visible"),

    /** At least two primitives are visible. */
    SEVERAL_VISIBLE("several primitives are visible"),

    /** At some sample two primitives have the same depth, which is the winning one. */
    TIE("a tie at the winning depth"),

    /** At some sample a primitive is hidden by another or by the background. */
    HIDDEN("something is hidden"),

    /** Each of two primitives is in front of the other at some sample. */
    CROSSING("two primitives cross"),

    /** In some row a primitive begins where another one ends, for example at a shared edge. */
    MEETING("two primitives meet"),

    /** Some sample is covered by more than eight primitives. */
    DEEP("more than 8 primitives at a sample"),

    /** Some primitive has more than six spans in a row. */
    MANY_SPANS("more than 6 spans in a row"),

    /** Only a part of the raster is requested. */
    REGION("a region"),

    /** More than 64 columns or rows are requested. */
    SEVERAL_TILES("more than 64 columns or rows"),

    /** At least one primitive is translucent. */
    TRANSLUCENT("translucency"),

    /** The depth of some primitive is not a linear form. */
    FORMLESS("depth without a linear form"),

    /** The raster has one row or one column. */
    NARROW("one row or one column"),

    /** The depth test is `LESS`. */
    LESS("the depth test LESS"),

    /** The depth test is `LESS_OR_EQUAL`. */
    LESS_OR_EQUAL("the depth test LESS_OR_EQUAL"),

    /** The depth test is `GREATER`. */
    GREATER("the depth test GREATER"),

    /** The depth test is `GREATER_OR_EQUAL`. */
    GREATER_OR_EQUAL("the depth test GREATER_OR_EQUAL"),

    /** The convention is `SMALLER_IS_NEARER`. */
    SMALLER_IS_NEARER("smaller depth is nearer"),

    /** The convention is `LARGER_IS_NEARER`. */
    LARGER_IS_NEARER("larger depth is nearer"),

    /** The background is not behind everything. */
    BACKGROUND_DEPTH("a background that is not behind everything"),

    /** The scene has a mesh. */
    MESH("a mesh"),

    /** The scene has a sphere. */
    SPHERE("a sphere"),

    /** The scene has points. */
    POINTS("points"),

    /** The scene has lines. */
    LINES("lines"),

    /** The scene has lights. */
    LIT("lights"),

    /** The scene has a spot. */
    SPOT("a spot"),

    /** The scene has a light that decreases with the distance. */
    FALLOFF("light that falls off"),

    /** The scene has an intensity of light other than 1. */
    LIGHT_INTENSITY("an intensity of light"),

    /** The scene has a visibility of ambient light. */
    AMBIENT_VISIBILITY("a visibility of ambient light"),

    /** The scene has an exposure other than 0 or a tone curve. */
    TONE_MAPPING("exposure or a tone curve"),

    /** A surface of the scene has a texture. */
    TEXTURED("a texture"),

    /** A surface of the scene has a map with a mip filter. */
    MIP_FILTER("a mip filter"),

    /** A mesh of the scene has a map that uses its second texture coordinates. */
    SECOND_UVS("second texture coordinates"),

    /** A mesh of the scene has a normal map and tangents. */
    NORMAL_MAP("a normal map"),

    /** A surface of the scene has a metallic-roughness material. */
    PHYSICAL("a metallic-roughness material"),

    /** Such a surface reflects an environment. */
    ENVIRONMENT("an environment"),

    /** A surface of the scene has a mask. */
    MASKED("a mask"),

    /** A polygon or triangle of the scene has vertices on both sides of the near plane. */
    NEAR_PLANE("something across the near plane"),

    /** The renderer is configured with options or a selector, or is used in another special way. */
    CONFIGURED("a renderer with options"),
}

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
