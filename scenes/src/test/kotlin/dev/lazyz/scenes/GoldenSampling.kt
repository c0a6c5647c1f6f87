package dev.lazyz.scenes

import dev.lazyz.Rgba
import dev.lazyz.ShadingRate
import dev.lazyz.filter.PixelBackground.VerticalGradient
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.SuperSampling.PixelFilter

/**
 * How a scene of [GoldenTest] becomes pixels, other than by one sample a pixel in front of one colour.
 *
 * @property id the last word of the picture's name
 * @property scenes ids of the scenes that are rendered in this way
 * @property gradient replaces the background; or null
 */
internal class GoldenSampling(
    val id: String,
    val sampling: SuperSampling,
    val scenes: List<String>,
    val gradient: VerticalGradient? = null,
) {
    companion object {
        private val smooth = SuperSampling(3, PixelFilter.BLACKMAN_HARRIS)
        private val sky = VerticalGradient(Rgba.ofRgb(0x3070C0), Rgba.ofRgb(0xFFF0E0))

        val all: List<GoldenSampling> = listOf(
            GoldenSampling("box-2", SuperSampling(2), listOf("phong", "edges", "matcap")),
            GoldenSampling(
                "box-4", SuperSampling(4), listOf("blend", "edges-dashed", "section", "sparse", "on-ground"),
            ),
            GoldenSampling("mitchell-4", SuperSampling(4, PixelFilter.MITCHELL), listOf("phong", "blend")),
            GoldenSampling("blackman-harris-3", smooth, listOf("phong", "blend")),
            GoldenSampling(
                "box-4-pixel", SuperSampling(4, rate = ShadingRate.PIXEL), listOf("anisotropic", "metallic", "mask"),
            ),
            GoldenSampling(
                "box-4-auto", SuperSampling(4, rate = ShadingRate.AUTO), listOf("phong", "blend", "normal-map"),
            ),
            GoldenSampling(
                "mitchell-3-pixel", SuperSampling(3, PixelFilter.MITCHELL, ShadingRate.PIXEL),
                listOf("trilinear", "normal-map"),
            ),
            GoldenSampling("gradient", SuperSampling.NONE, listOf("mask", "blend"), sky),
            GoldenSampling("gradient-box-4", SuperSampling(4), listOf("wireframe", "on-ground"), sky),
        )
    }
}
