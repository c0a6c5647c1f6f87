package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.split
import com.github.ajalt.clikt.parameters.options.transformAll
import dev.lazyz.cli.input.PixelSizes
import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.input.Translucency
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.filter.ShadingRate
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat

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
 * @param spoolBytes most bytes of temporary files, or null for those that are free
 */
internal fun subject(
    input: String,
    reading: ReadingOptions,
    limits: LimitOptions,
    picture: PictureOptions,
    light: LightOptions,
    camera: CameraOptions,
    lines: LineOptions,
    usualSamples: Int = picture.usualSamples,
    isSelected: Boolean = false,
    usualSize: ImageSize? = picture.usualSize,
    memory: Long? = null,
    spoolBytes: Long? = null,
): Subject {
    val style = picture.style
    val ownLimits = limits.limits(spoolBytes)
    val loadLimits = if (memory == null) ownLimits else ownLimits.withMemory(memory)
    val lightChoice = light.choice(picture)
    val usualRate = if (lightChoice.hasOcclusion && !isSelected) ShadingRate.PIXEL else ShadingRate.SAMPLE
    return Subject(
        input = input,
        format = reading.format,
        loading = LoadOptions(loadLimits, reading.animationTime),
        timeLimit = limits.time,
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
internal fun ParameterHolder.comparedStrategies() = severalStrategies(
    "Compare this strategy; for more, separate ids by commas, or repeat the option; all others are compared with " +
        "the first; default: all of 'zcli strategies'",
)

/** An option `--strategy` for several, separated by commas or repeated. */
internal fun ParameterHolder.severalStrategies(help: String) = option(
    "--strategy",
    metavar = "ID",
    help = help,
    completionCandidates = Completions.lists { Strategies.ids() },
).split(",").transformAll { it.flatten() }

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

private val formats = SceneFormat.entries.associateBy { it.id }

private val upAxes = UpAxis.entries.associateBy { it.id }
