package dev.lazyz.cli.render

import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.cli.input.Input
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputClosed
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.OutputTemplate
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.printable
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.conformance.report.ShellWords
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.pictures.Blank
import dev.lazyz.scenes.pictures.PictureDrawing
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.ImageFormat
import dev.lazyz.scenes.writers.PfmSink
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.scenes.writers.PpmSink
import dev.lazyz.scenes.writers.deepzoom.DeepZoomFiles
import dev.lazyz.scenes.writers.deepzoom.DeepZoomSink
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension

/**
 * The outputs of a rendering: a picture, to a file or to standard output, and optionally a file of its depth. A picture
 * that is compared with a reference is only written if the user names a file.
 */
internal class Outputs(private val request: RenderRequest, input: Input, private val streams: Streams) {
    private val isStandardOutput = request.output == STANDARD_OUTPUT

    /** The file of the picture, or null. */
    private val picture: Path? = when (val output = request.output) {
        null -> if (request.reference == null) defaultPath(input) else null
        STANDARD_OUTPUT -> null
        else -> Path.of(output)
    }

    /** The file if the picture is a drawing, or null. */
    val drawing: Path? = picture?.takeIf(PictureFile::isDrawing)

    /** All files that are written, each with its option. */
    private val files: List<Pair<String, Path>> = listOfNotNull(
        picture?.let { "-o" to it },
        request.depthOutput?.let { "--depth-out" to it },
        request.reference?.diff?.let { "--diff" to it },
    ) + request.aovs.files

    /** Those that exist already. */
    val replaced = OutputPlaces(files.flatMap { (option, path) -> PictureFile.places(path).map { option to it } })

    init {
        if (picture != null) {
            OutputFile.check(picture, "-o", PictureFile.ENDINGS, alternative = ", or be - for standard output")
        } else if (isStandardOutput && streams.isOutputTerminal) {
            throw Mistake("cannot write a picture to a terminal; redirect standard output, or use -o FILE.png")
        }
        request.depthOutput?.let { OutputFile.check(it, "--depth-out", listOf(".pfm")) }
        request.reference?.diff?.let { OutputFile.check(it, "--diff", listOf(".png")) }
        OutputFile.requireDistinct(listOfNotNull(request.reference?.let { "--ref" to it.file }) + files)
        request.shown.requireKept(replaced)
        request.reference?.let { replaced.requireNone(listOf(it.file), "the file of --ref") }
        request.resumption?.requirePossible(picture, input.isStandardInput, wholePictures())
    }

    /** The options for which all rows are needed. */
    private fun wholePictures(): List<String> = listOfNotNull(
        request.depthOutput?.let { "--depth-out" },
        request.aovs.files.firstOrNull()?.first?.substringBefore(' '),
        request.reference?.let { "--ref" },
        request.blanks.takeIf { it.isMistake }?.let { "--fail-blank" },
    )

    /**
     * Calls [render] with a sink that writes rows to all outputs, and with the picture to be rendered: [shot], or those
     * of its rows that are missing. The files exist after this method has returned; if it throws, they are not created.
     *
     * @param facts what the picture depends on, if it may be completed later, or null
     */
    fun <T> write(shot: PictureFrame, facts: Map<String, String>?, render: (RowSink, PictureFrame) -> T): T = try {
        if (facts != null && picture != null) {
            PictureFile.resume(picture, shot.pixels, shot.alpha, facts) { sink, rest ->
                render(sink, shot.within(rest))
            }
        } else {
            // The outermost file is finished last: the file of depth appears only after the picture is complete
            writeDepth(shot.pixels) { depth ->
                writePicture(shot) { picture -> render(FanOut(listOfNotNull(picture, depth)), shot) }
            }
        }
    } catch (closed: OutputClosed) {
        val missing = missing() ?: throw closed
        throw Mistake("standard output was closed before the end, and $missing")
    }

    /** Returns what is missing, besides the picture, if the picture is not complete, or null. */
    private fun missing(): String? = when {
        request.depthOutput != null -> "${request.depthOutput} was not written"

        // They are complete if all rows had been rendered
        request.aovs.files.isNotEmpty() -> "${request.aovs.files.first().second} may not have been written"

        else -> request.reference?.let { "the picture was not compared with ${it.file}" }
    }

    private fun <T> writePicture(shot: PictureFrame, render: (RowSink?) -> T): T {
        if (picture != null || isStandardOutput) {
            PictureFile.warnings(picture, shot.pixels, shot.alpha).forEach { streams.warning(it) }
        }
        if (picture != null) {
            return PictureFile.write(picture, shot.pixels, shot.alpha, render)
        }
        if (!isStandardOutput) return render(null)
        return PngSink(streams.output, shot.pixels.width, shot.pixels.height, shot.alpha).use(render)
    }

    private fun <T> writeDepth(region: Region, render: (RowSink?) -> T): T {
        val path = request.depthOutput ?: return render(null)
        return PictureFile.write(path, region, AlphaChannel.DROP, render)
    }

    /** Returns the memory for writing a picture of the pixels of [region]. */
    fun memory(region: Region): List<RenderPlan.Item> = listOfNotNull(
        (picture?.toString() ?: "-".takeIf { isStandardOutput })?.let {
            val resuming = if (request.resumption == null) 0 else DeepZoomSink.resumingMemory(region.width)
            RenderPlan.Item("output -o $it", PictureFile.memory(picture, region) + resuming)
        },
        request.depthOutput?.let { RenderPlan.Item("output --depth-out $it", PfmSink.memory(region.width)) },
    )

    /** Prints which files were written. */
    fun describe(region: Region) {
        if (picture != null) streams.remark("wrote $picture, ${region.width}x${region.height}")
        request.depthOutput?.let { streams.remark("wrote $it") }
        request.aovs.files.forEach { (_, it) -> streams.remark("wrote $it") }
    }

    /** Returns the default file. Throws if it exists, because it may be, for example, a texture of the model. */
    private fun defaultPath(input: Input): Path {
        val name = input.baseName ?: throw Mistake("specify the output file: -o FILE.png, or -o - for a pipe")
        val path = Path.of("$name.png")
        if (Files.exists(path)) {
            val template = OutputTemplate.of("$path")
            throw Mistake("${printable("$path")} exists; to replace it, use -o ${ShellWords.quoted(template)}")
        }
        return path
    }

    companion object {
        const val STANDARD_OUTPUT = "-"
    }
}

/** Passes each row to several sinks, in their order. */
internal class FanOut(private val sinks: List<RowSink>) : RowSink {
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        for (sink in sinks) sink.row(y, argb, depth, primitive)
    }
}

/** Writes pictures to files; a file appears when it is complete. */
internal object PictureFile {
    private const val GIGAPIXEL = 1e9
    private const val DRAWING = "svg"
    private const val PYRAMID = ".${DeepZoomFiles.EXTENSION}"

    /** What the names of pictures may end in. */
    val ENDINGS: List<String> = listOf(".png", ".ppm", PYRAMID, ".$DRAWING")

    /** Whether [path] names a Deep Zoom pyramid: a file and a folder. */
    fun isPyramid(path: Path): Boolean = path.extension.equals(DeepZoomFiles.EXTENSION, ignoreCase = true)

    /** Whether [path] names a drawing, whose lines are vectors. */
    fun isDrawing(path: Path): Boolean = path.extension.equals(DRAWING, ignoreCase = true)

    /** Returns what is replaced if a picture is written to [path]: the file, and the folder of a pyramid's tiles. */
    fun places(path: Path): List<Path> =
        if (isPyramid(path)) listOf(path, DeepZoomFiles.tiles(path)) else listOf(path)

    /**
     * Returns warnings about the file [path], or a PNG file on standard output if that is null, for the pixels of
     * [region] with this [alpha]: where alpha is lost, and where another kind of file is better.
     */
    fun warnings(path: Path?, region: Region, alpha: AlphaChannel): List<String> {
        if (path != null && isPyramid(path)) return emptyList()
        val isPpm = path != null && ImageFiles.formatOf(path) == ImageFormat.PPM
        return listOfNotNull(
            "a .ppm file has no alpha: what is transparent is written as opaque; use .png".takeIf {
                isPpm && alpha == AlphaChannel.KEEP
            },
            (
                "the picture has %.1f gigapixels, and few programs open one file of that size; -o NAME$PYRAMID makes " +
                    "a pyramid of tiles, of which a viewer in a browser loads what it shows"
                ).format(null, region.size / GIGAPIXEL).takeIf { region.size > GIGAPIXEL },
        )
    }

    /** Returns the memory for writing the pixels of [region] to [path], or as PNG to standard output if it is null. */
    fun memory(path: Path?, region: Region): Long = when {
        path == null -> PngSink.memory(region.width, region.height)
        isPyramid(path) -> DeepZoomSink.memory(region.width, region.height)
        ImageFiles.formatOf(path) == ImageFormat.PPM -> PpmSink.memory(region.width)
        else -> PngSink.memory(region.width, region.height)
    }

    /**
     * Calls [render] with a sink that writes the pixels of [region] to [path].
     *
     * @throws IOException if the file cannot be written; the message says which, why, and what to do
     */
    fun <T> write(path: Path, region: Region, alpha: AlphaChannel, render: (RowSink) -> T): T {
        if (isPyramid(path)) return DeepZoomFiles.write(path, region.width, region.height, alpha, render)
        return ImageFiles.write(path, region.width, region.height, alpha = alpha, produce = render)
    }

    /**
     * Writes [drawing] to [path]; a strategy of [choice] renders what is below the lines.
     *
     * @return why there is nothing to see, or null
     */
    fun write(path: Path, drawing: PictureDrawing, choice: StrategyChoice): Blank? {
        val below = drawing.picture ?: return drawing.writeSvg(path)
        val strategy = choice.strategyFor(below.frame)
        Strategies.requireMemory(strategy, below.frame.region, aa = below.factor)
        return drawing.writeSvg(path, strategy)
    }

    /**
     * Completes the pyramid [path] of the pixels of [region], which depends on [facts]. Calls [render] with a sink and
     * the rows that are missing.
     */
    fun <T> resume(
        path: Path,
        region: Region,
        alpha: AlphaChannel,
        facts: Map<String, String>,
        render: (RowSink, Region) -> T,
    ): T = DeepZoomFiles.resume(path, region.width, region.height, alpha, facts) { sink, first ->
        render(sink, region.rows(region.rowStart + first, region.rowEnd))
    }
}
