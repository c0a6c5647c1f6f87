package dev.lazyz.scenes.scenefile

import dev.lazyz.DepthTest
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.world.FittedViewpoint.Fit
import dev.lazyz.world.ToneMapping
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter

/** The names of the library's enum constants in scene files: lower case, with hyphens. */
internal object SceneFileNames {
    val projections: Map<String, Fit> = names(Fit.entries)
    val shadings: Map<String, Shading> = names(Shading.entries)
    val alphaModes: Map<String, AlphaMode> = names(AlphaMode.entries)
    val sides: Map<String, Sides> = names(Sides.entries)
    val filters: Map<String, Texture.Filter> = names(Texture.Filter.entries)
    val mipFilters: Map<String, MipFilter> = names(MipFilter.entries)
    val wraps: Map<String, Texture.Wrap> = names(Texture.Wrap.entries)
    val encodings: Map<String, Texture.Encoding> = names(Texture.Encoding.entries)
    val toneCurves: Map<String, ToneMapping.Curve> = names(ToneMapping.Curve.entries)
    val lightRigs: Map<String, LightRig> = names(LightRig.entries)
    val fillRules: Map<String, FillRule> = names(FillRule.entries)

    val conventions: Map<String, DepthConvention> = names(DepthConvention.entries)
    val depthTests: Map<String, DepthTest> = names(DepthTest.entries)

    val upAxes: Map<String, UpAxis> = UpAxis.entries.associateBy { it.id }

    const val INVERSE_SQUARE: String = "inverse-square"

    /** Whether a light decreases with the square of the distance. */
    val falloffs: Map<String, Boolean> = mapOf("none" to false, INVERSE_SQUARE to true)

    fun of(constant: Enum<*>): String = constant.name.lowercase().replace('_', '-')

    private fun <T : Enum<T>> names(constants: List<T>): Map<String, T> = constants.associateBy { of(it) }
}
