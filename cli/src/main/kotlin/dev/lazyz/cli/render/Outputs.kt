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
import dev.lazyz.conformance.report.ShellWords
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.PfmSink
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.scenes.writers.deepzoom.DeepZoomSink
import java.nio.file.Files
import java.nio.file.Path

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
