package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.Coherence
import dev.lazyz.DepthConvention
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.cli.input.AntiAliasing
import dev.lazyz.cli.input.PictureStyle
import dev.lazyz.cli.input.PixelSizes
import dev.lazyz.cli.input.Placement
import dev.lazyz.cli.input.PointOfView
import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.input.Translucency
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.filter.PixelFilter
import dev.lazyz.filter.ShadingRate
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.Projection
import dev.lazyz.world.View
import dev.lazyz.world.material.MipFilter
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Points

/** The help text of INPUT. */
internal const val INPUT_HELP: String =
    "A model (.obj, .stl, .ply, .off, .3mf, .gltf, .glb), a scene file (.json), the name of a built-in scene " +
        "(see 'zcli scenes'), or - for standard input"

/**
 * Returns the subject that the options describe for [input].
 *
 * @param usualSamples samples a pixel in each direction if the user does not choose
 * @param isSelected whether a pixel shows other fragments than the nearest
 * @param usualSize the size of the picture if the user does not choose; null means that of the scene
 * @param memory bytes of memory that may be used, or null for all that Java may use
 */
internal fun subject(
    input: String,
    reading: ReadingOptions,
    limits: LimitOptions,
    picture: PictureOptions,
    light: LightOptions,
    camera: CameraOptions,
    lines: LineOptions,
    usualSamples: Int,
    isSelected: Boolean = false,
    usualSize: ImageSize? = null,
    memory: Long? = null,
): Subject {
    val style = picture.style
    val lightChoice = light.choice(picture)
    val usualRate = if (lightChoice.hasOcclusion && !isSelected) ShadingRate.PIXEL else ShadingRate.SAMPLE
    return Subject(
        input = input,
        format = reading.format,
        loading = LoadOptions(limits.limits().withMemory(memory), reading.animationTime),
        up = reading.up,
        size = picture.size ?: usualSize,
        region = picture.region,
        antiAliasing = picture.antiAliasing(usualSamples, usualRate),
        background = picture.background,
        color = picture.color,
        texture = picture.texture,
        shading = picture.shading,
        toneCurve = light.toneCurve,
        exposure = light.exposure,
        mipFilter = picture.mipFilter,
        sizes = PixelSizes(picture.pointSize, picture.lineWidth),
        translucency = if (picture.isOpaque) Translucency.OPAQUE else Translucency.BLENDED,
        depthConvention = picture.depthConvention,
        pointOfView = camera.pointOfView(),
        lineWork = lines.lineWork(style),
        light = lightChoice,
        style = style,
    )
}

/** The option `--classpath`. */
internal fun ParameterHolder.classPath() = option(
    "--classpath",
    metavar = "JAR",
    help = "Also load strategies from here: a jar with an entry META-INF/services/dev.lazyz.Renderer, or a jar " +
        "that it needs; repeat the option for more",
).multiple()

/** The option `--strategy` of commands that compare strategies. */
internal fun ParameterHolder.comparedStrategies() = option(
    "--strategy",
    metavar = "ID",
    help = "Compare this strategy; repeat the option for more; all others are compared with the first; " +
        "default: all of 'zcli strategies'",
).multiple()

/** Options for reading the input. */
internal class ReadingOptions : OptionGroup("Reading") {
    val format by option("--format", help = "Format of INPUT: ${names(formats.keys)}; default: by its extension")
        .oneOf("FORMAT", formats)

    val up by option(
        "--up",
        help = "Which axis of the model points up: ${names(upAxes.keys)}; default: z for .stl and .3mf, otherwise y",
    ).oneOf("AXIS", upAxes)

    val animationTime by option(
        "--animation-time",
        help = "Show the model at this moment of its first animation (glTF), 0..1000000; default: at rest",
    ).number("SECONDS", 0.0..1e6, " seconds")
}

/** Options of the picture. */
internal class PictureOptions : OptionGroup("Picture") {
    val size by option(
        "--size",
        help =
        "Width and height in pixels, each 1..262144, or one number for a square; default: the scene file's, or " +
            "640x480",
    ).size()

    val region by option(
        "--region",
        help = "Render only this part of the picture, with the same pixels: column and row of its upper left pixel, " +
            "from 0,0; width and height",
    ).region()

    private val samples by option(
        "--aa",
        help = "Anti-aliasing: N x N samples a pixel, N is 1, 2, 4 or 8; default: 4 for render, 1 for compare",
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

/** Options of the camera. */
internal class CameraOptions : OptionGroup("Camera") {
    private val choice by option(
        "--camera",
        help = "fit: show all of the scene; scene: its own camera; or the number of a camera of a model, from 0; " +
            "default: fit for models, scene for scene files and built-in scenes",
    ).camera()

    val view by option("--view", help = "Look from ${names(words(View.entries).keys)}")
        .oneOf("SIDE", words(View.entries))

    private val azimuth by option("--azimuth", help = "Degrees around the up axis: 0 front, 90 right; default: 30")
        .number("DEGREES", -1e6..1e6, " degrees")

    private val elevation by option("--elevation", help = "Degrees above the horizon, -90..90; default: 20")
        .number("DEGREES", -90.0..90.0, " degrees")

    private val projection by option("--projection", help = "perspective or orthographic; default: perspective")
        .oneOf("KIND", words(Fit.entries))

    private val margin by option(
        "--margin",
        help = "Free part of the picture on each side, 0..45 percent; default: ${Camera.DEFAULT_MARGIN.toInt()}",
    ).number("PERCENT", 0.0..45.0, " percent")

    private val zoom by option(
        "--zoom",
        help = "1 shows what the camera shows, 2 shows half as much; 0.001..1000; default: 1",
    ).number("FACTOR", 0.001..1000.0, "")

    private val fieldOfView by option(
        "--fov",
        help = "Vertical field of view of a perspective camera at zoom 1, above 0 and below 180, or at most " +
            "${Camera.MAX_FITTED_FIELD_OF_VIEW.toInt()} without --eye if the camera is fitted; default: " +
            "${Camera.DEFAULT_FIELD_OF_VIEW.toInt()}, or the camera's",
    ).number("DEGREES") { Projection.Perspective(it) }

    private val eye by option("--eye", help = "Position of the camera; default: where it shows all of the scene")
        .vector()

    private val target by option("--target", help = "The point in the middle of the picture; default: the scene's")
        .vector()

    private val up by option("--camera-up", help = "The direction that is up in the picture; default: the up axis")
        .vector()

    private val height by option("--height", help = "Visible height of an orthographic picture; default: it fits")
        .number("UNITS") { Projection.Orthographic(it) }

    private val near by option("--near", help = "Distance of the near plane, world units; default: it fits")
        .number("DISTANCE") { require(it.isFinite()) { "near must be finite: $it" } }

    private val far by option("--far", help = "Distance of the far plane, world units; default: it fits")
        .number("DISTANCE") { require(it.isFinite()) { "far must be finite: $it" } }

    private val isPrinted by option(
        "--print-camera",
        help = "Print to standard error the options that give exactly this camera",
    ).flag()

    fun pointOfView() = PointOfView(
        choice, view, azimuth, elevation, projection, margin, zoom, fieldOfView,
        Placement(eye, target, up, height, near, far), isPrinted,
    )
}

/** Options that change time and memory of the rendering. */
internal class CostOptions : OptionGroup("Cost (the picture stays the same; see 'zcli strategies --long')") {
    private val memoryBudget by option(
        "--memory-budget",
        help = "Maximum working memory of a strategy that can limit it, without the picture and the scene: bytes, or " +
            "with k, m, g (64k, 16MiB); default: no limit. --memory, in contrast, is for the whole program",
    ).bytes()

    private val coherence by option(
        "--coherence",
        help = "How late shading proceeds from pixel to pixel: direct (each separately), incremental (by steps) or " +
            "adaptive (the cheaper one); default: direct",
    ).oneOf("MODE", words(Coherence.entries))

    private val threads by option("--threads", help = "Number of threads, 1 or more; default: one per processor")
        .count { RenderOptions(threads = it) }

    private val tileSize by option(
        "--tile-size",
        help = "Width and height of tiles, a power of two in 8..512; default: ${RenderOptions().tileSize}",
    ).count { RenderOptions(tileSize = it) }

    fun choices(selector: Selector? = null) = Choices(memoryBudget, coherence, threads, tileSize, selector)
}

/** Smallest accepted size. Sizes below a pixel are rendered as one pixel. */
private const val LEAST_SIZE = 0.001

private val formats = SceneFormat.entries.associateBy { it.id }

private val upAxes = UpAxis.entries.associateBy { it.id }

private val filters = words(PixelFilter.entries)

private val mipFilters = words(MipFilter.entries)

private val shadings = words(Shading.entries)
