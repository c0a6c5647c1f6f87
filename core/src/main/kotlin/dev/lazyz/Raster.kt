package dev.lazyz

/**
 * The grid of samples that a frame is rendered on, and what it holds before the first primitive.
 *
 * Column x grows to the right and row y downward; the sample of pixel (x, y) is at its centre (contract rule 1.1).
 * Immutable and thread safe.
 *
 * @property width number of columns, 1..[MAX_SIDE]
 * @property height number of rows, 1..[MAX_SIDE]
 * @property background colour of samples that nothing covers, linear light
 * @property convention which way depth grows
 * @property depthTest which of two fragments of a sample is visible
 * @property backgroundDepth depth of the background; what does not pass [depthTest] against it is invisible. The
 *   default lies behind everything: the textbooks' infinity
 * @throws IllegalArgumentException if a side or [backgroundDepth] is out of range
 */
public class Raster @JvmOverloads constructor(
    public val width: Int,
    public val height: Int,
    public val background: Rgba = Rgba.WHITE,
    public val convention: DepthConvention = DepthConvention.SMALLER_IS_NEARER,
    public val depthTest: DepthTest = convention.nearest,
    public val backgroundDepth: Int = convention.farthest,
) {
    init {
        require(width in 1..MAX_SIDE) { "width must be in 1..$MAX_SIDE: $width" }
        require(height in 1..MAX_SIDE) { "height must be in 1..$MAX_SIDE: $height" }
        require(backgroundDepth >= 0) { "backgroundDepth must not be negative: $backgroundDepth" }
    }

    /** Number of samples. */
    public val size: Long get() = width.toLong() * height

    /** All samples. */
    public val region: Region get() = Region(0, 0, width, height)

    override fun toString(): String =
        "Raster($width x $height, $background, $convention, $depthTest, backgroundDepth=$backgroundDepth)"

    public companion object {
        /** The greatest width and height, in samples. */
        public const val MAX_SIDE: Int = 262_144
    }
}

/**
 * Which way depth grows (contract rule 4.1). Both give the same picture; the stored depths are mirrored.
 *
 * @property farthest the depth that lies behind everything, the usual one of a background
 */
public enum class DepthConvention(public val farthest: Int) {
    /** Depth grows away from the viewer; the background is at maximum depth. */
    SMALLER_IS_NEARER(Int.MAX_VALUE) {
        override val nearest: DepthTest get() = DepthTest.LESS
    },

    /** Depth grows toward the viewer; the background is at depth 0. */
    LARGER_IS_NEARER(0) {
        override val nearest: DepthTest get() = DepthTest.GREATER
    },
    ;

    /** The depth test that shows what is nearest. */
    public abstract val nearest: DepthTest
}

/**
 * Decides which of two fragments of a sample is visible: a total order of (depth, submission index).
 *
 * Each order is the minimum of one 64-bit [key], so fragments may be compared in any order, by any number of threads
 * (contract rule 5).
 */
public enum class DepthTest {
    /** The least depth; among equals what was submitted first. The background counts as submitted before all. */
    LESS,

    /** The least depth; among equals what was submitted last. */
    LESS_OR_EQUAL,

    /** The greatest depth; among equals what was submitted first. */
    GREATER,

    /** The greatest depth; among equals what was submitted last. */
    GREATER_OR_EQUAL,
    ;

    private val isReversed: Boolean get() = this == GREATER || this == GREATER_OR_EQUAL
    private val isLastFirst: Boolean get() = this == LESS_OR_EQUAL || this == GREATER_OR_EQUAL

    /**
     * Returns the sort key of a fragment: the visible fragment of a sample is the one of least key.
     *
     * @param depth 0..2^31-1
     * @param index submission index, 0..2^31-2, or [BACKGROUND] for the background
     */
    public fun key(depth: Int, index: Int): Long {
        val upper = if (isReversed) Int.MAX_VALUE - depth else depth
        val rank = index + 1
        val lower = if (isLastFirst) Int.MAX_VALUE - rank else rank
        return upper.toLong() shl 32 or lower.toLong()
    }

    /** Returns the depth within a [key]. */
    public fun depthOf(key: Long): Int {
        val upper = (key ushr 32).toInt()
        return if (isReversed) Int.MAX_VALUE - upper else upper
    }

    /** Returns the submission index within a [key], or [BACKGROUND]. */
    public fun indexOf(key: Long): Int {
        val lower = key.toInt()
        return (if (isLastFirst) Int.MAX_VALUE - lower else lower) - 1
    }

    public companion object {
        /** The submission index that stands for the background: no primitive. */
        public const val BACKGROUND: Int = -1
    }
}
