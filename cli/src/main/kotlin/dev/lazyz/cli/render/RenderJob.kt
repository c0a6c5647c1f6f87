package dev.lazyz.cli.render

import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.cli.diff.DifferenceText
import dev.lazyz.cli.diff.writeMarked
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputTemplate
import dev.lazyz.cli.output.Progress
import dev.lazyz.cli.output.Statistics
import dev.lazyz.cli.output.StatisticsTable
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Tally
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference
import java.nio.file.Files
import java.nio.file.Path
import kotlinx.serialization.json.JsonObject

/** One run of `zcli render`: reads, sets up, chooses a strategy, renders to all sinks at once, compares, reports. */
internal class RenderJob(private val request: RenderRequest, private val streams: Streams) {
    // These report mistakes in the options before anything is read
    private val source = FrameSource(request.shown, streams)
    private val choice = StrategyChoice(request.strategy, request.choices)
    private val outputs = Outputs(request, source.input, streams)
    private val reference = request.reference?.let { ReferenceCheck(it) }
    private val planning = request.memory?.let { MemoryPlanning(it, request, source, choice, ::others) }

    /** Returns the exit code. */
    fun run(): Int = TimeLimit.OF_PROCESS.hold(request.shown.timeLimit, source.input.name) {
        runAnyway()
    }

    private fun runAnyway(): Int {
        request.streaming?.requirePossible(request)
        if (planning == null) return run(request.streaming)
        val streaming = request.streaming ?: planning.streaming()
        return try {
            run(streaming)
        } catch (refusal: MemoryRefusal) {
            if (request.streaming != null || !planning.hasOtherWay(streaming, refusal)) throw refusal
            runOtherwise(refusal, if (streaming == null) request.streamingForMemory else null)
        }
    }

    /** Reads the model in another way after [refusal]. If that does not fit either, reports what needs less. */
    private fun runOtherwise(refusal: MemoryRefusal, streaming: StreamRequest?): Int = try {
        run(streaming)
    } catch (other: MemoryRefusal) {
        throw listOf(refusal, other).minBy { it.enough ?: Long.MAX_VALUE }
    }

    private fun run(streaming: StreamRequest?): Int {
        if (streaming == null) {
            val whole = if (planning == null) source else FrameSource(request.shown, streams, planning.loading)
            return run(prepared(isWhole = true) { whole.load() }, null)
        }
        return prepared(isWhole = false) { source.stream(streaming.spool) }.use { run(it.loaded, streaming) }
    }

    /**
     * Calls [prepare], and reports it if the memory is not enough for that.
     *
     * @param isWhole whether the model is kept in memory
     */
    private fun <T> prepared(isWhole: Boolean, prepare: () -> T): T = when {
        planning != null -> planning.preparing(prepare)
        isWhole -> request.streamingForMemory.advised(request, source.input.statedFormat, choice, prepare)
        else -> prepare()
    }

    private fun run(loaded: LoadedScene, streaming: StreamRequest?): Int {
        // Set up, and choose a strategy that supports the frame
        source.requireKept(loaded, outputs.replaced)
        outputs.drawing?.let { return draw(it, loaded) }
        val start = System.nanoTime()
        planning?.requireSetUp(loaded)
        val shot = prepared(isWhole = streaming == null) { source.frame(loaded, request.choices.options()) }
        val frame = shot.frame
        val plan = planning?.plan(shot)
        val strategy = plan?.renderer ?: choice.strategyFor(frame)
        if (request.isExplained) {
            val memory = planning?.memory ?: Runtime.getRuntime().maxMemory()
            streams.note(choice.explain(strategy, frame, memory))
            if (plan != null) streams.note(planning.explain(plan, frame, streaming))
        }
        val kept = (reference?.bytesPerPixel ?: 0) + request.aovs.bytesPerPixel / (shot.factor * shot.factor)
        Strategies.requireMemory(strategy, frame.region, kept, aa = shot.factor)

        // Render to all outputs at once
        streams.progress("rendering ${frame.primitives.size} primitives with ${strategy.id} ...")
        val tally = Tally(shot.pixels.width, request.stats != null)
        val colors = reference?.let { ColorRows(shot.pixels) }
        val aovs = request.aovs.aovs
        var rendered = shot.pixels
        val counters = outputs.write(shot, request.resumption?.facts(source, loaded)) { sink, part ->
            rendered = part.pixels
            val progress = Progress(streams, part.pixels.height, "rows")
            val all = FanOut(listOfNotNull(sink, tally, colors, RowSink { _, _, _, _ -> progress.advance() }))
            if (aovs.isEmpty()) {
                part.render(strategy, all)
            } else {
                part.render(strategy, all, aovs).also { request.aovs.write(it) }.counters
            }
        }
        val nanoseconds = System.nanoTime() - start

        // Report
        if (rendered == shot.pixels) request.blanks.report(tally.blank, streams)
        outputs.describe(shot.pixels)
        val name = source.input.name
        val difference = colors?.let { reference.compare(it) }
        val comparison = difference?.let { DifferenceText("${request.reference?.file}", name, it) }
        if (difference?.isMatch == false) streams.note(comparison?.lines.orEmpty())
        if (request.stats != null) {
            val warnings = loaded.warnings.size
            val statistics =
                Statistics(name, strategy, rendered, shot, counters, tally, warnings, nanoseconds)
            printStatistics(request.stats, statistics, comparison?.toJson())
        }
        return request.blanks.code(if (difference?.isMatch == false) ExitCode.DIFFERENT else ExitCode.DONE)
    }

    /** Writes the lines of [loaded] to [file]. */
    private fun draw(file: Path, loaded: LoadedScene): Int {
        val drawing = prepared(isWhole = true) { source.drawing(loaded, request.choices.options()) }
        request.blanks.report(BlankPictures.reason(PictureFile.write(file, drawing, choice)), streams)
        outputs.describe(drawing.pixels)
        return request.blanks.code(ExitCode.DONE)
    }

    /** What receives the [pixels]; those that are kept to be compared, and other data of each of them. */
    private fun others(pixels: Region): List<RenderPlan.Item> {
        val kept = ((reference?.bytesPerPixel ?: 0) + request.aovs.bytesPerPixel) * pixels.size
        val items = if (kept == 0L) emptyList() else listOf(RenderPlan.Item("pixels that are kept", kept))
        return outputs.memory(pixels) + items
    }

    /** Prints [statistics] to standard output, or to standard error if standard output contains the picture. */
    private fun printStatistics(form: StatsForm, statistics: Statistics, comparison: JsonObject?) {
        val text = if (form == StatsForm.JSON) statistics.toJson(comparison) + "\n" else StatisticsTable.of(statistics)
        if (request.output == Outputs.STANDARD_OUTPUT) streams.messages.print(text) else streams.print(text)
    }
}

/**
 * Compares a picture with the reference of [request], which is read at once.
 *
 * @throws Mistake if there is no reference; the message has the command that creates it
 */
internal class ReferenceCheck(private val request: ReferenceRequest) {
    private val reference = if (Files.exists(request.file)) {
        Picture.read(request.file)
    } else {
        throw Mistake("there is no reference ${request.file}; create it with\n${request.creation}")
    }

    /** Memory for a pixel of the picture that is compared, and of the picture of the differences. */
    val bytesPerPixel: Long = if (request.diff == null) BYTES else BYTES + DIFF_BYTES

    /** Compares [colors], after all rows have arrived, and writes the picture of the differences. */
    fun compare(colors: ColorRows): PictureDifference {
        val difference = PictureDifference.between(reference, colors.toPicture(), request.threshold)
        request.diff?.let { difference.writeMarked(it) }
        return difference
    }

    private companion object {
        const val BYTES = 4L
        const val DIFF_BYTES = 12L
    }
}

/** Keeps the colours of the pixels of [region]. */
internal class ColorRows(private val region: Region) : RowSink {
    /** The colours in rows from the top, `0xAARRGGBB`. */
    val argb = IntArray(Math.toIntExact(region.size))

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        argb.copyInto(this.argb, (y - region.rowStart) * region.width, 0, region.width)
    }

    /** Returns the colours, without copying them. */
    fun toPicture(): Picture = Picture.ofArgb(region.width, region.height, argb)
}

/**
 * With what `zcli render` compares the picture.
 *
 * @property file the reference, an image file
 * @property threshold the greatest difference of a channel that is accepted, 0..255
 * @property diff the file for a picture of the differences, or null
 * @param args the words of the command line
 */
internal class ReferenceRequest(
    val file: Path,
    val threshold: Double,
    val diff: Path?,
    private val args: List<String>,
) {
    /** The command that renders the same picture to [file]. */
    val creation: String
        get() {
            val kept = CommandLine.without(args, setOf("-o", "--output", "--ref", "--ref-threshold", "--diff"))
            return CommandLine.of(kept.take(1) + listOf("-o", OutputTemplate.of("$file")) + kept.drop(1))
        }
}
