package dev.lazyz.scenes

import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba

/**
 * The depth rules of a [Raster]. By default the nearest fragment is visible. Immutable and thread safe.
 *
 * @property convention whether smaller or greater depths are nearer
 * @property test decides which of two fragments of a sample is visible
 * @property background depth of the background, 0..2^31-1; by default behind everything
 * @throws IllegalArgumentException if [background] is negative
 */
public class DepthRules @JvmOverloads constructor(
    public val convention: DepthConvention = DepthConvention.SMALLER_IS_NEARER,
    public val test: DepthTest = convention.nearest,
    public val background: Int = convention.farthest,
) {
    init {
        require(background >= 0) { "depth of the background must be in 0..${Int.MAX_VALUE}: $background" }
    }

    /** Returns a raster with these rules. Throws like the constructor of [Raster]. */
    public fun raster(width: Int, height: Int, color: Rgba): Raster =
        Raster(width, height, color, convention, test, background)

    override fun equals(other: Any?): Boolean =
        other is DepthRules && convention == other.convention && test == other.test && background == other.background

    override fun hashCode(): Int = (convention.hashCode() * 31 + test.hashCode()) * 31 + background

    override fun toString(): String = "DepthRules($convention, $test, background=$background)"

    public companion object {
        /** Returns the rules of [raster]. */
        @JvmStatic
        public fun of(raster: Raster): DepthRules =
            DepthRules(raster.convention, raster.depthTest, raster.backgroundDepth)
    }
}
