package dev.lazyz.cli.input

import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.cli.output.Mistake
import dev.lazyz.filter.PixelFilter
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.ShadingRate
import dev.lazyz.filter.SuperSampling
import dev.lazyz.world.Scene

/**
 * The options of anti-aliasing.
 *
 * @property factor samples a pixel in each direction; null means [usual], or 1 where that is not possible
 * @property rate how often primitives are shaded; null means [usualRate], or each sample where that is not possible
 */
internal class AntiAliasing(
    private val factor: Int?,
    private val usual: Int,
    private val filter: PixelFilter,
    private val rate: ShadingRate?,
    private val usualRate: ShadingRate,
) {
    /** Samples a pixel in each direction, unless that is not possible. */
    val wanted: Int get() = factor ?: usual

    /** An option that needs the whole model in memory, or null. */
    val wholeModel: String? get() = if (rate == ShadingRate.PIXEL) "--shading-rate pixel" else null

    /** Sets up [scene] for the samples of the pixels of [raster]. */
    fun frame(scene: Scene, raster: Raster, options: RenderOptions): SampledFrame {
        val wish = SuperSampling(wanted, filter)
        val obstacle = wish.obstacle(scene, raster)
        if (obstacle != null && factor != null) throw Mistake("--aa $factor: $obstacle; use --aa 1")
        val sampling = if (obstacle == null) wish else SuperSampling(1, filter)
        val sampled = sampling.frame(scene, raster, options)
        if ((rate ?: usualRate) == ShadingRate.SAMPLE) return sampled
        if (!sampled.frame.hasTranslucency) {
            return SuperSampling(sampling.factor, filter, ShadingRate.PIXEL).of(sampled.frame)
        }
        if (rate == null) return sampled
        throw Mistake("--shading-rate pixel: the scene is translucent; use --shading-rate sample, or --opaque")
    }
}
