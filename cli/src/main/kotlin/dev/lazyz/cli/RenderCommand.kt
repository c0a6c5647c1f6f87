package dev.lazyz.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.optionalValue
import dev.lazyz.DepthConvention
import dev.lazyz.Fit
import dev.lazyz.Shading
import dev.lazyz.scenes.SceneFormat
import java.nio.file.Path

/** `zcli render`: declares the options; [RenderJob] does the work. */
internal class RenderCommand(private val streams: Streams) : Command("render") {
    private val input by argument(
        "INPUT",
        help = "A model (.obj, .stl, .ply, .gltf, .glb), a scene file (.json), the name of a built-in scene " +
            "(see 'zcli scenes'), or - for standard input",
    )
    private val reading by ReadingOptions()
    private val picture by PictureOptions()
    private val camera by CameraOptions()
    private val rendering by RenderingOptions()

    override fun help(context: Context): String =
        "Renders a model or a scene to a picture.\n\nWithout further options the camera frames the whole model from " +
            "the front right, a little above, and a model without lights gets some that show its shape."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli render teapot -o teapot.png" to "a built-in scene, 640x480",
        "zcli render part.stl --up z --view iso --projection orthographic -o part.png" to "a part from a CAD program",
        "zcli render model.glb --size 512x512 --background transparent -o model.png" to "a thumbnail to put on a page",
        "zcli render city -o city.png --depth-out city.pfm --stats=json" to "picture, depth, and numbers for a script",
        "cat model.obj | zcli render - --format obj -o - > model.png" to "in a pipe",
    )

    override fun run() {
        val request = RenderRequest(
            input = input,
            format = reading.format,
            up = reading.up,
            output = picture.output,
            depthOutput = picture.depthOutput,
            size = picture.size,
            background = picture.background,
            strategy = rendering.strategy,
            shading = rendering.shading,
            pointOfView = camera.pointOfView(),
            depthConvention = picture.depthConvention,
            stats = rendering.stats,
        )
        RenderJob(request, streams).run()
    }
}

/** How to read the input. */
private class ReadingOptions : OptionGroup("Reading") {
    val format by option("--format", help = "What INPUT is: ${names(formats.keys)}; default: by its name's ending")
        .oneOf("FORMAT", formats)

    val up by option("--up", help = "Which axis of the model points up: y or z; default: y")
        .oneOf("AXIS", Up.entries.associateBy { it.name.lowercase() })
        .default(Up.Y)
}

/** What the picture is like, and where it goes. */
private class PictureOptions : OptionGroup("Picture") {
    val output by option(
        "-o",
        "--output",
        metavar = "OUT",
        help = "Where the picture goes: a .png or .ppm file, or - for PNG to standard output; default: INPUT's name " +
            "with .png in the current folder, if there is no such file yet",
    )

    val size by option(
        "--size",
        help = "Width and height in pixels, each 1..262144; default: the scene file's, or 640x480",
    ).size()

    val background by option(
        "--background",
        help = "black, white, transparent, or hexadecimal rgb, rrggbb, rrggbbaa; default: the scene's, or white",
    ).color()

    val depthOutput by option(
        "--depth-out",
        help = "Also write the depth of every pixel to a .pfm file: 0 at the near plane, 1 at the far plane, " +
            "infinity where nothing is",
    ).convert("FILE") { Path.of(it) }

    val depthConvention by option(
        "--depth-convention",
        help = "Which depth is nearer: smaller or larger; the picture is the same; default: smaller",
    ).oneOf(
        "ORDER",
        mapOf(
            "smaller" to DepthConvention.SMALLER_IS_NEARER,
            "larger" to DepthConvention.LARGER_IS_NEARER,
        ),
    ).default(DepthConvention.SMALLER_IS_NEARER)
}

/** Where to look from. */
private class CameraOptions : OptionGroup("Camera (any of these frames the whole scene)") {
    private val view by option("--view", help = "Look from ${names(View.entries.map { it.name.lowercase() })}")
        .oneOf("SIDE", View.entries.associateBy { it.name.lowercase() })

    private val azimuth by option("--azimuth", help = "Degrees around the up axis: 0 front, 90 right; default: 30")
        .number("DEGREES", -1e6..1e6, " degrees")

    private val elevation by option("--elevation", help = "Degrees above the horizon, -90..90; default: 20")
        .number("DEGREES", -90.0..90.0, " degrees")

    private val zoom by option("--zoom", help = "1 fills the picture, 2 shows half as much; 0.001..1000; default: 1")
        .number("FACTOR", 0.001..1000.0, "")

    private val projection by option("--projection", help = "perspective or orthographic; default: perspective")
        .oneOf("KIND", Fit.entries.associateBy { it.name.lowercase() })

    fun pointOfView() = PointOfView(view, azimuth, elevation, zoom, projection)
}

/** How to compute it. */
private class RenderingOptions : OptionGroup("Rendering") {
    val strategy by option(
        "--strategy",
        metavar = "ID",
        help = "How hidden surfaces are removed (see 'zcli strategies'); the picture is the same; default: zbuffer",
    ).default("zbuffer")

    val shading by option("--shading", help = "Replace all materials' shading: ${names(shadings.keys)}")
        .oneOf("SHADING", shadings)

    val stats by option(
        "--stats",
        help = "Tell what it took, as a table or, with --stats=json, as one JSON object; to standard output, or to " +
            "standard error if the picture goes to standard output",
    ).oneOf("json", StatsForm.entries.associateBy { it.name.lowercase() })
        .optionalValue(StatsForm.TABLE, acceptsUnattachedValue = false)
}

private val formats = SceneFormat.entries.associateBy { it.id }

private val shadings = Shading.entries.associateBy { it.name.lowercase().replace('_', '-') }

private fun names(all: Collection<String>): String = all.toList().dropLast(1).joinToString() + " or " + all.last()
