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
 */
internal class AntiAliasing(
    private val factor: Int?,
    private val usual: Int,
    private val filter: PixelFilter,
    val rate: ShadingRate,
) {
    /** Sets up [scene] for the samples of the pixels of [raster]. */
    fun frame(scene: Scene, raster: Raster, options: RenderOptions): SampledFrame {
        val wish = SuperSampling(factor ?: usual, filter, rate)
        val obstacle = wish.obstacle(scene, raster) ?: return wish.frame(scene, raster, options)
        if (factor != null) throw Mistake("--aa $factor: $obstacle; use --aa 1")
        return SuperSampling(1, filter, rate).frame(scene, raster, options)
    }
}
