package dev.lazyz.filter

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.ShadingRate
import dev.lazyz.setup.ShadingPoints
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface

/**
 * Anti-aliasing by several samples a pixel: [factor] x [factor] samples on a regular grid, and a filter.
 *
 * ```
 * val image = SuperSampling(4).frame(scene, Raster(640, 480)).render(TiledRenderer())
 * ```
 *
 * The frame of samples is an ordinary one, of a raster [factor] times as wide and as high, so every renderer, option
 * and region works, and all renderers give the same bits. A pixel's colour is the mean of its samples in linear light,
 * weighted by the filter and by their alpha; its alpha is the mean alpha. The samples are those of contract rule 6.4,
 * so each has 8 bits a component. Sums are of integers, so their order does not matter. Depth and primitive are those
 * of the pixel's sample that wins the depth test. A pixel without alpha has the colour of its upper left sample.
 *
 * Cost: [factor]^2 samples a pixel. Memory: that of the renderer for rows of samples, and 44 bytes a column of pixels
 * for each row that the filter covers, and 52 more. Rows are passed on as soon as their samples are complete. Immutable
 * and thread safe.
 *
 * @property factor samples a pixel in each direction, 1..[MAX_FACTOR]
 * @property filter how samples are weighted
 * @property rate how often primitives are shaded
 * @throws IllegalArgumentException if [factor] is out of range
 */
public class SuperSampling @JvmOverloads constructor(
    public val factor: Int,
    public val filter: PixelFilter = PixelFilter.BOX,
    public val rate: ShadingRate = ShadingRate.SAMPLE,
) {
    init {
        require(factor in 1..MAX_FACTOR) { "factor must be in 1..$MAX_FACTOR: $factor" }
    }

    internal val taps = FilterTaps(filter, factor)

    /** Where primitives are shaded that are shaded once a pixel, or null if there are none. */
    internal val points = if (factor == 1 || rate == ShadingRate.SAMPLE) null else ShadingPoints(factor, rate)

    /**
     * Sets up [scene] for the samples of [pixels]. Sizes of [Points] and [Lines] stay as they are in pixels, see
     * [Surface.magnified].
     *
     * @param options the threads of set-up, see [Scene.frame]
     * @throws IllegalArgumentException if there is an [obstacle]
     * @throws InterruptedException as [Scene.frame]
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun frame(scene: Scene, pixels: Raster, options: RenderOptions = RenderOptions()): SampledFrame {
        if (factor == 1) return of(scene.frame(pixels, options))
        obstacle(scene, pixels)?.let { throw IllegalArgumentException(it) }
        val magnified = scene.withSurfaces(scene.surfaces.map { it.magnified(factor) })
        return of(magnified.frame(pixels.withSize(pixels.width * factor, pixels.height * factor), options))
    }

    /**
     * Returns why [frame] does not accept [scene] and [pixels], or null if it does. With a [factor] above 1, it does
     * not if the scene is given on the screen ([Scene.isOnScreen]), because that is in samples; if the raster of
     * samples has a side above [Raster.MAX_SIDE]; or if a point or a line is wider than [Points.MAX_SIZE] samples.
     */
    public fun obstacle(scene: Scene, pixels: Raster): String? {
        val most = Raster.MAX_SIDE / factor
        val widest = Points.MAX_SIZE / factor
        val size = scene.surfaces.maxOfOrNull { it.pixelSize } ?: 0.0
        return when {
            factor == 1 -> null

            scene.isOnScreen -> "a scene that is given on the screen has one sample a pixel"

            maxOf(pixels.width, pixels.height) > most ->
                "with $factor x $factor samples a pixel, a side has at most $most pixels: " +
                    "${pixels.width} x ${pixels.height}"

            size > widest ->
                "with $factor x $factor samples a pixel, points and lines are at most $widest pixels wide: $size"

            else -> null
        }
    }

    /**
     * Returns the picture whose samples are those of [samples], for a frame that does not come from a scene.
     *
     * @throws IllegalArgumentException if the region of the frame does not consist of whole pixels
     */
    public fun of(samples: Frame): SampledFrame {
        val region = samples.region
        val sides = listOf(region.columnStart, region.rowStart, region.columnEnd, region.rowEnd)
        require(sides.all { it % factor == 0 }) { "$region must consist of pixels of $factor x $factor samples" }
        val pixels = Region(sides[0] / factor, sides[1] / factor, sides[2] / factor, sides[3] / factor)
        return SampledFrame(this, samples.within(samples.raster.region), pixels)
    }

    override fun toString(): String = "SuperSampling($factor, $filter, $rate)"

    /**
     * How the samples around a pixel are weighted. The weight of a sample is the product of a weight for its column and
     * one for its row, so every filter is separable.
     *
     * @property radius how far from the centre of a pixel samples count, pixels
     */
    public enum class PixelFilter(public val radius: Double) {
        /** All samples of the pixel, with equal weights. The fastest, and exact for areas. */
        BOX(0.5),

        /**
         * Mitchell and Netravali's cubic filter with B = C = 1/3: sharp. It has small negative weights, so next to a
         * strong edge there is a faint line. Source: "Reconstruction Filters in Computer Graphics", SIGGRAPH 1988.
         */
        MITCHELL(2.0),

        /**
         * The window of Blackman and Harris, four terms: smooth, without negative weights. Source: F. Harris, "On the
         * Use of Windows for Harmonic Analysis with the Discrete Fourier Transform", Proceedings of the IEEE 66, 1978.
         */
        BLACKMAN_HARRIS(1.5),
        ;

        /** Returns the weight at [distance] from the centre, pixels; not normalised. */
        internal fun weight(distance: Double): Double {
            val x = StrictMath.abs(distance)
            return when (this) {
                BOX -> 1.0
                MITCHELL -> mitchell(x)
                BLACKMAN_HARRIS -> blackmanHarris(StrictMath.PI * x / radius)
            }
        }

        private fun mitchell(x: Double): Double = when {
            x < 1.0 -> (7.0 * x * x * x - 12.0 * x * x + 16.0 / 3.0) / 6.0
            x < 2.0 -> (-7.0 / 3.0 * x * x * x + 12.0 * x * x - 20.0 * x + 32.0 / 3.0) / 6.0
            else -> 0.0
        }

        private fun blackmanHarris(angle: Double): Double =
            if (angle >= StrictMath.PI) {
                0.0
            } else {
                0.35875 + 0.48829 * StrictMath.cos(angle) + 0.14128 * StrictMath.cos(2 * angle) +
                    0.01168 * StrictMath.cos(3 * angle)
            }
    }

    public companion object {
        /** The largest [factor]. */
        public const val MAX_FACTOR: Int = 64

        /** One sample a pixel. */
        @JvmField
        public val NONE: SuperSampling = SuperSampling(1)
    }
}
