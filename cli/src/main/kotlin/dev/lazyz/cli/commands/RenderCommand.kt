package dev.lazyz.cli.commands

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.optionalValue
import dev.lazyz.Selector
import dev.lazyz.cli.batch.BatchJob
import dev.lazyz.cli.batch.BatchRequest
import dev.lazyz.cli.input.NamedInputs
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.options.AovOptions
import dev.lazyz.cli.options.CameraOptions
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.CostOptions
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.INPUT_HELP
import dev.lazyz.cli.options.LimitOptions
import dev.lazyz.cli.options.MemoryOptions
import dev.lazyz.cli.options.MessageOptions
import dev.lazyz.cli.options.ParameterOptions
import dev.lazyz.cli.options.SeriesOptions
import dev.lazyz.cli.options.StreamOptions
import dev.lazyz.cli.options.classPath
import dev.lazyz.cli.options.number
import dev.lazyz.cli.options.oneOf
import dev.lazyz.cli.options.path
import dev.lazyz.cli.options.selector
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputTemplate
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.render.PictureFile
import dev.lazyz.cli.render.ReferenceRequest
import dev.lazyz.cli.render.RenderJob
import dev.lazyz.cli.render.RenderRequest
import dev.lazyz.cli.render.Resumption
import dev.lazyz.cli.render.StatsForm
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.cli.strategies.StrategyPath
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.PictureParameters.AA
import dev.lazyz.scenes.pictures.PictureParameters.FORMAT
import dev.lazyz.scenes.pictures.PictureParameters.OPAQUE
import dev.lazyz.scenes.pictures.PictureParameters.SCALE
import dev.lazyz.scenes.pictures.PictureParameters.SIZE
import dev.lazyz.scenes.pictures.PictureParameters.VIEW
import java.nio.file.Files
import java.nio.file.Path

/**
 * `zcli render`: declares the options. [RenderJob] renders one picture, and [BatchJob] several.
 *
 * @param args the words of the command line, for the command that creates a missing reference, and for bug reports
 */
internal class RenderCommand(private val streams: Streams, private val args: List<String>) : Command("render") {
    private val inputs by argument(
        "INPUT",
        help = "$INPUT_HELP; or a folder: all models and scene files in it",
        completionCandidates = Completions.inputs,
    ).multiple(required = true)
    private val output by OutputOptions()
    private val aovs by AovOptions()
    private val several by SeriesOptions()
    private val reference by ReferenceOptions()
    private val reading by ParameterOptions(ParameterGroup.READING)
    private val streaming by StreamOptions()
    private val picture by ParameterOptions(ParameterGroup.PICTURE)
    private val light by ParameterOptions(ParameterGroup.LIGHT)
    private val camera by CameraOptions()
    private val lines by ParameterOptions(ParameterGroup.LINES)
    private val paper by ParameterOptions(ParameterGroup.PAPER)
    private val rendering by RenderingOptions()
    private val memory by MemoryOptions()
    private val cost by CostOptions()
    private val limits by LimitOptions()
    private val outcome by MessageOptions()

    /** What the options choose. */
    private val settings by lazy {
        // The colours of a count are names of numbers, which must not be mixed
        val usual = ParameterOptions.NONE
        val start = if (rendering.selector == Selector.count()) usual.withDefault(AA, 1) else usual
        listOf(reading, picture, light, camera, lines, paper).fold(start) { all, group -> group.addTo(all) }
    }

    override fun help(context: Context): String =
        "Renders models or scenes to pictures.\n\nBy default the camera shows the whole model from the front " +
            "right, slightly from above, and a model without lights gets default lights. Only for a single picture: " +
            "--resume, --depth-out, --aov, --aov-picture, --ref, --explain, --stream, --memory and -o -. Exit " +
            "code 1: the picture differs from that of --ref; 2: an input could not be rendered, the others were."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli render teapot -o teapot.png" to "a built-in scene, 640x480",
        "zcli render part.stl --view iso --projection orthographic -o part.png" to "a part from a CAD program",
        "zcli render model.glb --size 512x512 --background transparent -o model.png" to "a thumbnail for a web page",
        "zcli render city -o city.png --depth-out city.pfm --stats=json" to "also depth and statistics, for a script",
        "zcli render city -o city.png --aov depth,normal,object=city.npz" to "data of each pixel, for NumPy",
        "zcli render part.stl --style technical --scale 1:2 -o part.svg" to "a drawing to print, as vectors",
        "zcli render city --size 8000x6000 --region 4000,2000,640x480 -o detail.png" to "a part of a large picture",
        "zcli render city --size 100000 -o huge.dzi --resume" to "ten gigapixels, for a viewer in a browser",
        "zcli render city --size 20000 --memory 128m --explain -o large.png" to "in 128 MiB, and how",
        "zcli render city --strategy auto --explain -o city.png" to "the fastest strategy for it, and why",
        "zcli render city --select count -o overdraw.png" to "the number of surfaces at each pixel",
        "zcli render city --ref city.png --diff where.png" to "is the picture still that of city.png? for tests",
        "zcli render models/ a.stl -o 'out/{stem}_{view}.png' --views iso,front,top" to "many inputs and views",
        "zcli render part.stl --turntable 36 -o part.gif" to "a turning model; .png is an animated PNG",
        "zcli render models/ --contact-sheet -o sheet.png" to "all models of a folder in one picture",
        "cat model.obj | zcli render - --format obj -o - > model.png" to "in a pipe",
    )

    override fun run() {
        val blanks = outcome.applyTo(streams)
        if (output.stats != null) requireAttachedForm()
        if (settings[OPAQUE] == true && rendering.selector == Selector.blend()) {
            throw Mistake("--select blend has no effect with --opaque, which leaves nothing to blend: omit one of them")
        }
        val spooling = streaming.spoolOption
        if (spooling != null && streaming.request == null && memory.bytes == null) {
            throw Mistake("$spooling needs --stream, or --memory")
        }
        val whole = limits.wholeOption
        if (whole != null && streaming.request != null) {
            throw Mistake(
                "$whole has no effect with --stream, which keeps no decoded input; use --max-triangles, " +
                    "--max-vertices or --max-spool",
            )
        }

        requireKindOfFile()
        val named = NamedInputs(inputs, settings[FORMAT])
        val series = several.series()
        val isSingle = named.isSingle && several.views == null && series.turntable == null && !series.isSheet &&
            series.columns == null && series.framesPerSecond == null
        val template = output.picture?.let { OutputTemplate(it) }
        val code = StrategyPath.with(rendering.classPath) {
            if (isSingle && template?.placeholders.isNullOrEmpty()) {
                RenderJob(single(template?.name, blanks), streams).run()
            } else {
                BatchJob(several(named, blanks), streams).run()
            }
        }
        end(code)
    }

    /** Checks that no option is about another kind of file. */
    private fun requireKindOfFile() {
        if (output.picture?.let { PictureFile.isDrawing(Path.of(it)) } != true) {
            if (settings[SCALE] != null) throw Mistake("--scale is for drawings: use -o with .svg")
            return
        }
        val others = listOfNotNull(
            output.stats?.let { "--stats" }, rendering.selector?.let { "--select" },
            several.series().turntable?.let { "--turntable" },
        )
        val option = (alone() + others).firstOrNull() ?: return
        throw Mistake("$option is for pictures of pixels, and .svg is a drawing; use -o with .png")
    }

    /** The options that were given of those for a single picture. */
    private fun alone(): List<String> = listOfNotNull(
        output.depth?.let { "--depth-out" },
        aovs.outputs.files.firstOrNull()?.first?.substringBefore(' '),
        reference.request(args)?.let { "--ref" },
        if (rendering.isExplained) "--explain" else null,
        streaming.request?.let { "--stream" },
        if (output.isResumed) Resumption.OPTION else null,
        memory.bytes?.let { "--memory" },
    )

    /** Reports a form of statistics that is separated from `--stats`, so that it is taken as an input. */
    private fun requireAttachedForm() {
        val word = args.getOrNull(args.indexOf("--stats") + 1) ?: return
        val form = word.lowercase()
        if (form in NamedValues.words(StatsForm.entries) && !Files.exists(Path.of(word))) {
            throw Mistake("'$word' is taken as INPUT, and there is no such file; did you mean '--stats=$form'?")
        }
    }

    private fun single(picture: String?, blanks: BlankPictures) = RenderRequest(
        shown = shown(inputs.single(), null),
        output = picture,
        depthOutput = output.depth,
        aovs = aovs.outputs,
        strategy = rendering.strategy,
        choices = cost.choices(rendering.selector),
        isExplained = rendering.isExplained,
        stats = output.stats,
        reference = reference.request(args),
        streaming = streaming.request,
        streamingForMemory = streaming.forMemory,
        resumption = if (output.isResumed) Resumption(args) else null,
        memory = memory.bytes,
        blanks = blanks,
    )

    private fun several(named: NamedInputs, blanks: BlankPictures): BatchRequest {
        val series = several.series()
        val views = several.views.orEmpty()
        val alone = alone()
        if (alone.isNotEmpty()) throw Mistake("${alone[0]} is for a single picture, and this renders several")
        settings.check()
        val directed = settings.directed
        if (views.isNotEmpty() && directed != null) throw Mistake("--views cannot be combined with $directed")
        val placed = settings.placed
        if (series.turntable != null && placed != null) throw Mistake("--turntable cannot be combined with $placed")
        return BatchRequest(
            inputs = named.all.toList(),
            shown = { shown(it, if (series.isSheet) CELL_SIZE else null) },
            views = views,
            viewName = settings[VIEW]?.name?.lowercase() ?: "default",
            output = output.picture,
            series = series,
            strategy = rendering.strategy,
            choices = cost.choices(rendering.selector),
            stats = output.stats,
            blanks = blanks,
            args = args,
        )
    }

    private fun shown(input: String, usualSize: ImageSize?): ShownInput {
        val all = limits.limits(streaming.spoolBytes)
        val bytes = memory.bytes
        val own = if (usualSize == null) settings else settings.withDefault(SIZE, usualSize)
        return ShownInput(input, own, if (bytes == null) all else all.withMemory(bytes), limits.time, camera.isPrinted)
    }

    private companion object {
        /** The size of a picture of a contact sheet without --size. */
        val CELL_SIZE = ImageSize(256, 256)
    }
}

/** Options of the output files and of statistics. */
private class OutputOptions : OptionGroup("Output") {
    val picture by option(
        "-o",
        "--output",
        metavar = "OUT",
        completionCandidates = CompletionCandidates.Path,
        help = "The file for the picture: .png, .ppm, .dzi (a Deep Zoom pyramid, for web viewers) or .svg (lines as " +
            "vectors, with --edges, --wireframe or --style technical), or - for PNG to standard output; default: " +
            "INPUT's name with .png in the current folder, if that file does not exist yet; none with --ref. For " +
            "several pictures, with {dir}, {stem}, {name} or {ext} of INPUT, {view}, {index} or {frame}",
    )

    val isResumed by option(
        Resumption.OPTION,
        help = "If the rendering of a .dzi picture is interrupted, keep what is done, in NAME_files.partial; if an " +
            "earlier run with the same input and options was interrupted, go on where it stopped",
    ).flag()

    val depth by option(
        "--depth-out",
        help = "Also write the depth of every pixel to a .pfm file: 0 at the near plane, 1 at the far plane, " +
            "infinity for the background",
    ).path()

    val stats by option(
        "--stats",
        help = "Print statistics, as a table or, with --stats=json, as one JSON object; to standard output, or to " +
            "standard error if the picture goes to standard output",
    ).oneOf("json", NamedValues.words(StatsForm.entries))
        .optionalValue(StatsForm.TABLE, acceptsUnattachedValue = false)
}

/** Options of the comparison with a reference. */
private class ReferenceOptions : OptionGroup("Reference") {
    private val file by option(
        "--ref",
        help = "Compare the picture with this image file, pixel by pixel; exit code 1 if they differ",
    ).path()

    private val threshold by option(
        "--ref-threshold",
        help = "The greatest difference of a channel from the reference that is accepted, 0..255, in 8-bit code " +
            "values; default: 0",
    ).number("CODES", 0.0..255.0, "")

    private val diff by option(
        "--diff",
        help = "Write a picture of the differences from the reference, a .png file: yellow to red where the " +
            "pictures differ",
    ).path()

    /** Returns what the options ask for, or null if the picture is not compared. */
    fun request(args: List<String>): ReferenceRequest? {
        val reference = file?.let { ReferenceRequest(it, threshold ?: 0.0, diff, args) }
        if (reference == null && threshold != null) throw Mistake("--ref-threshold needs --ref")
        if (reference == null && diff != null) throw Mistake("--diff needs --ref")
        return reference
    }
}

/** Options of the strategy. */
private class RenderingOptions : OptionGroup("Rendering") {
    val strategy by option(
        "--strategy",
        metavar = "ID",
        completionCandidates = Completions.words { Strategies.ids() + StrategyChoice.AUTO },
        help = "The algorithm that removes hidden surfaces; the picture is the same; auto: choose by expected time; " +
            "default: the first of 'zcli strategies' that supports what the scene and the other options need",
    )

    val classPath by classPath()

    val isExplained by option(
        "--explain",
        help = "Print to standard error why this strategy was chosen, and the expected times of all",
    ).flag()

    val selector by option(
        "--select",
        help = "What a pixel shows of all the surfaces at it: nearest, farthest, kth:K (the K-th from the " +
            "front), count (their number, as a colour) or blend; default: nearest, or blend if the scene is " +
            "translucent",
    ).selector()
}
