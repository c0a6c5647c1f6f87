package dev.lazyz

/**
 * The grid of samples that a frame is rendered on, and its initial content.
 *
 * Columns x increase to the right and rows y downward. The sample of pixel (x, y) is at its centre (contract rule 1.1).
 * Immutable and thread safe.
 *
 * @property width number of columns, 1..[MAX_SIDE]
 * @property height number of rows, 1..[MAX_SIDE]
 * @property background colour of samples that no primitive covers, linear light
 * @property convention the direction in which depth increases
 * @property depthTest decides which of two fragments of a sample is visible
 * @property backgroundDepth depth of the background, 0..2^31-1. Fragments that do not pass [depthTest] against it are
 *   invisible. The default is behind everything, which textbooks call infinity
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

    /** The region of all samples. */
    public val region: Region get() = Region(0, 0, width, height)

    /** Returns this raster with [width] columns and [height] rows. */
    public fun withSize(width: Int, height: Int): Raster = copy(width = width, height = height)

    /**
     * Returns this raster with another direction of depth, and with the depth test and the depth of the background that
     * are usual for it, whatever they were before.
     */
    public fun withConvention(convention: DepthConvention): Raster = Raster(width, height, background, convention)

    /** Returns this raster with another colour of the background. */
    public fun withBackground(background: Rgba): Raster = copy(background = background)

    /**
     * Returns this raster with another depth test, and the same depth of the background. If the other test prefers the
     * other direction, set [withBackgroundDepth], too, or no fragment passes. [withConvention] sets all of these.
     */
    public fun withDepthTest(depthTest: DepthTest): Raster = copy(depthTest = depthTest)

    /** Returns this raster with another depth of the background, 0..2^31-1. */
    public fun withBackgroundDepth(backgroundDepth: Int): Raster = copy(backgroundDepth = backgroundDepth)

    private fun copy(
        width: Int = this.width,
        height: Int = this.height,
        background: Rgba = this.background,
        depthTest: DepthTest = this.depthTest,
        backgroundDepth: Int = this.backgroundDepth,
    ): Raster = Raster(width, height, background, convention, depthTest, backgroundDepth)

    override fun toString(): String =
        "Raster($width x $height, $background, $convention, $depthTest, backgroundDepth=$backgroundDepth)"

    /**
     * The direction in which depth increases (contract rule 4.1). Both conventions give the same image, but the stored
     * depths are mirrored.
     *
     * @property farthest the depth behind everything, the default for a background
     */
    public enum class DepthConvention(public val farthest: Int) {
        /** Depth increases away from the viewer; the background is at the maximum depth, 2^31-1. */
        SMALLER_IS_NEARER(Int.MAX_VALUE) {
            override val nearest: DepthTest get() = DepthTest.LESS
        },

        /** Depth increases toward the viewer; the background is at depth 0. */
        LARGER_IS_NEARER(0) {
            override val nearest: DepthTest get() = DepthTest.GREATER
        },
        ;

        /** The depth test that makes the nearest fragment visible. */
        public abstract val nearest: DepthTest

        /** Returns the depth at the fraction [unit] of the range from the near plane (0) to the far plane (1). */
        internal fun ofUnit(unit: Double): Int = turned(Depth.ofUnit(unit))

        /**
         * Returns where [depth] is between the near plane (0) and the far plane (1); depths in the margins are clamped.
         */
        internal fun toUnit(depth: Int): Double = Depth.toUnit(turned(depth)).coerceIn(0.0, 1.0)

        private fun turned(depth: Int): Int = if (this == SMALLER_IS_NEARER) depth else Int.MAX_VALUE - depth
    }

    public companion object {
        /** Maximum width and height, in samples. */
        public const val MAX_SIDE: Int = 262_144
    }
}

/**
 * Decides which of two fragments of a sample is visible, by a total order of (depth, submission index).
 *
 * Each fragment has a 64-bit [key], and the fragment with the minimum key is visible. So fragments can be compared in
 * any order, by any number of threads (contract rule 5).
 */
public enum class DepthTest {
    /**
     * The smallest depth wins; ties go to the primitive submitted first. The background counts as submitted before all.
     */
    LESS,

    /** The smallest depth wins; ties go to the primitive submitted last. */
    LESS_OR_EQUAL,

    /** The greatest depth wins; ties go to the primitive submitted first. */
    GREATER,

    /** The greatest depth wins; ties go to the primitive submitted last. */
    GREATER_OR_EQUAL,
    ;

    private val isReversed: Boolean get() = this == GREATER || this == GREATER_OR_EQUAL
    private val isLastFirst: Boolean get() = this == LESS_OR_EQUAL || this == GREATER_OR_EQUAL

    /**
     * Returns the sort key of a fragment. The visible fragment of a sample is the one with the smallest key.
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

    /** Returns the depth that is encoded in a [key]. */
    public fun depthOf(key: Long): Int {
        val upper = (key ushr 32).toInt()
        return if (isReversed) Int.MAX_VALUE - upper else upper
    }

    /** Returns the submission index that is encoded in a [key], or [BACKGROUND]. */
    public fun indexOf(key: Long): Int {
        val lower = key.toInt()
        return (if (isLastFirst) Int.MAX_VALUE - lower else lower) - 1
    }

    public companion object {
        /** The submission index of the background: no primitive. */
        public const val BACKGROUND: Int = -1
    }
}

/**
 * Depth values as every frame stores them: 31-bit fixed point, 0..2^31-1 (contract rule 4).
 *
 * What a camera sees is in [NEAR]..[FAR]. The margins outside that range absorb rounding errors, and the planes of
 * polygons that are not exactly flat.
 */
public object Depth {
    /**
     * Size of the margin at each end of the range, which no vertex uses: 2^24 units, less than one percent of the
     * range.
     */
    public const val MARGIN: Int = 1 shl 24

    /** Depth of the near plane. */
    public const val NEAR: Int = MARGIN

    /** Depth of the far plane. */
    public const val FAR: Int = Int.MAX_VALUE - MARGIN

    /**
     * Returns the depth at the fraction [unit] of the way from the near plane (0) to the far plane (1), rounded to
     * nearest. [unit] is clamped to 0..1; NaN counts as 1, behind everything else.
     */
    @JvmStatic
    public fun ofUnit(unit: Double): Int =
        if (unit < 1.0) Math.rint(NEAR + maxOf(unit, 0.0) * (FAR.toDouble() - NEAR)).toInt() else FAR

    /**
     * Returns where [depth] is between the near plane (0) and the far plane (1). The result is outside 0..1 for depths
     * in the margins.
     */
    @JvmStatic
    public fun toUnit(depth: Int): Double = (depth.toDouble() - NEAR) / (FAR.toDouble() - NEAR)
}
