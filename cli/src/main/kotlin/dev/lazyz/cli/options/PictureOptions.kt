package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.DepthConvention
import dev.lazyz.cli.input.AntiAliasing
import dev.lazyz.filter.PixelFilter
import dev.lazyz.filter.ShadingRate
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.PictureStyle
import dev.lazyz.world.material.MipFilter
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Points

/**
 * Options of the picture.
 *
 * @property usualSamples samples a pixel in each direction if the user does not choose
 * @property usualSize the size if the user does not choose; null means that of the scene
 */
internal class PictureOptions(val usualSamples: Int = 1, val usualSize: ImageSize? = null) : OptionGroup("Picture") {
    val size by option(
        "--size",
        help = "Width and height in pixels, each 1..262144, or one number for a square; default: " +
            (usualSize?.let { "${it.width}x${it.height}" } ?: "the scene file's, or 640x480"),
    ).size()

    val region by option(
        "--region",
        help = "Render only this part of the picture, with the same pixels: column and row of its upper left pixel, " +
            "from 0,0; width and height",
    ).region()

    private val samples by option(
        "--aa",
        help = "Anti-aliasing: N x N samples a pixel, N is 1, 2, 4 or 8; default: $usualSamples",
    ).oneOf("N", listOf(1, 2, 4, 8).associateBy { "$it" })

    private val filter by option(
        "--aa-filter",
        help = "How samples are weighted: ${names(filters.keys)}; default: box",
    ).oneOf("FILTER", filters).default(PixelFilter.BOX)

    val shadingRate by option(
        "--shading-rate",
        help = "Shade at every visible sample, or once for each primitive in a pixel, for expensive shaders: sample " +
            "or pixel; default: sample, or pixel with --ambient-occlusion if that is possible",
    ).oneOf("RATE", words(ShadingRate.entries))

    val background by option(
        "--background",
        help = "A colour: a name of CSS, such as skyblue, transparent, or hexadecimal rgb, rrggbb, rrggbbaa; or two, " +
            "TOP,BOTTOM, for a gradient; default: the scene's, or white",
    ).backdrop()

    val color by option("--color", help = "Replace the colours and textures of all surfaces by this colour").color()

    val texture by option(
        "--texture",
        help = "Replace the colours and textures of all surfaces by this image, which --color multiplies; the model " +
            "needs texture coordinates",
    ).path()

    val shading by option("--shading", help = "Replace the shading of all materials: ${names(shadings.keys)}")
        .oneOf("SHADING", shadings)

    val mipFilter by option(
        "--texture-filter",
        help = "How textures are read where many texels fall on one sample: ${names(mipFilters.keys)}; default: " +
            "the scene file's, or anisotropic",
    ).oneOf("FILTER", mipFilters)

    val pointSize by option("--point-size", help = "Size of points in pixels, up to 4096; default: the input's, or 2")
        .number("PX", LEAST_SIZE..Points.MAX_SIZE.toDouble(), " pixels")

    val lineWidth by option("--line-width", help = "Width of lines in pixels, up to 4096; default: the input's, or 1")
        .number("PX", LEAST_SIZE..Points.MAX_SIZE.toDouble(), " pixels")

    val isOpaque by option("--opaque", help = "Render translucent materials as opaque; default: blended")
        .flag()

    val depthConvention by option(
        "--depth-convention",
        help = "Which depth is nearer: smaller or larger; the picture is the same; default: the scene file's, " +
            "or smaller",
    ).oneOf(
        "ORDER",
        mapOf(
            "smaller" to DepthConvention.SMALLER_IS_NEARER,
            "larger" to DepthConvention.LARGER_IS_NEARER,
        ),
    )

    val style by option(
        "--style",
        help = "Defaults for whole pictures. product: for a shop, with --ambient-occlusion, --ground-shadow and a " +
            "wide margin; technical: --edges, white surfaces without light, white background, orthographic",
    ).oneOf("STYLE", words(PictureStyle.entries))

    fun antiAliasing(usual: Int, usualRate: ShadingRate) =
        AntiAliasing(samples, usual, filter, shadingRate, usualRate)
}

/** Smallest accepted size. Sizes below a pixel are rendered as one pixel. */
private const val LEAST_SIZE = 0.001

private val filters = words(PixelFilter.entries)

private val mipFilters = words(MipFilter.entries)

private val shadings = words(Shading.entries)
