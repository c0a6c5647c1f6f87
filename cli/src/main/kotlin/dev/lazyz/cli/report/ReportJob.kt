package dev.lazyz.cli.report

import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.aov.AovFrame.AovImages
import dev.lazyz.cli.compare.CompareJob
import dev.lazyz.cli.compare.CompareRequest
import dev.lazyz.cli.compare.Comparison
import dev.lazyz.cli.compare.Outcome
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.ReportPlace
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.trace.ShadingOrder
import dev.lazyz.scenes.aov.ObjectTable
import dev.lazyz.scenes.aov.VisibleObject
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.pictures.PictureFrame
import java.nio.file.Path

/** One run of `zcli report`: compares, renders once more to see where the work is, and writes the page. */
internal class ReportJob(private val request: ReportRequest, private val streams: Streams) {
    private val choices = request.compared.choices

    fun run(): Report {
        // Report mistakes in the options before anything is read
        val page = ReportPlace(request.output, "-o").page
        val source = FrameSource(request.shown, streams)
        val replaced = OutputPlaces(listOf("-o" to page))
        request.shown.requireKept(replaced)
        val job = CompareJob(request.compared, streams, kept = bytesPerPixel())

        val loaded = source.load()
        source.requireKept(loaded, replaced)
        val comparison = job.compare(source, loaded)
        request.compared.blanks.report(comparison.blank, streams)
        val shot = comparison.shot
        val reference = comparison.reference?.image
        val entries = comparison.outcomes.map { (id, outcome) -> entry(Strategies.find(id), outcome, shot, reference) }
        val seen = seen(shot, entries)
        val parts = seen?.let { ObjectTable.of(it[Aov.OBJECT]) }.orEmpty()
        val report =
            Report(source.input.name, request.command, comparison, entries, seen?.get(Aov.OVERDRAW), parts)

        streams.progress("writing $page ...")
        OutputFile.createFolder(page)
        Html.write(page, ReportPage(report).html())
        streams.print(report.verdict + "\n")
        streams.remark("wrote $page")
        return report
    }

    private fun entry(strategy: Renderer, outcome: Outcome, shot: PictureFrame, reference: Image?): ReportEntry {
        if (outcome !is Outcome.Rendered) return ReportEntry(strategy.id, strategy.summary, outcome, null)
        streams.progress("looking at ${strategy.id} ...")
        return try {
            ReportEntry(strategy.id, strategy.summary, outcome, portrait(strategy, outcome, shot, reference))
        } catch (failure: Throwable) {
            // Continue with the other strategies
            ReportEntry(strategy.id, strategy.summary, Outcome.Failed(failure), null)
        }
    }

    private fun portrait(
        strategy: Renderer,
        outcome: Outcome.Rendered,
        shot: PictureFrame,
        reference: Image?,
    ): Portrait {
        val collector = Image.Collector(shot.pixels)
        val aovs = shot.render(choices.applyTo(strategy), collector, setOf(Aov.SHADING_CALLS))
        val isShort = outcome.counters.shadingCalls <= ShadingOrder.MOST
        val order = if (shot.isPlain && isShort) order(strategy, shot) else null
        val own = collector.toImage(aovs.counters)

        // Do not keep the same picture for each strategy
        val image = reference?.takeIf { it.pixelHash() == own.pixelHash() } ?: own
        return Portrait(image, aovs[Aov.SHADING_CALLS], order)
    }

    /** Records the calls of one thread, as `zcli trace` does. */
    private fun order(strategy: Renderer, shot: PictureFrame): OrderMap {
        val recorder = ShadingOrder.Recorder(shot.frame, strategy.id)
        shot.observed(recorder).render(choices.sharing(1).applyTo(strategy)) { _, _, _, _ -> }
        return OrderMap(recorder.toOrder(), shot.pixels)
    }

    /** Returns what is a property of the frame, so that any strategy that can render it will do. */
    private fun seen(shot: PictureFrame, entries: List<ReportEntry>): AovImages? =
        entries.firstOrNull { it.portrait != null }?.let { entry ->
            shot.render(Strategies.find(entry.id), { _, _, _, _ -> }, setOf(Aov.OVERDRAW, Aov.OBJECT))
        }

    /** Returns how many bytes for each pixel are kept besides what is compared. */
    private fun bytesPerPixel(): Long {
        val strategies = request.compared.strategies.size.takeIf { it > 0 } ?: Strategies.all().size
        return ONCE_PER_PIXEL + strategies * EACH_PER_PIXEL
    }

    private companion object {
        /** A picture to look at, the overdraw, the objects, a picture of a map, and what finds discarded calls. */
        const val ONCE_PER_PIXEL = 44L

        /** The counts and the order of a strategy, and their pictures on the page. */
        const val EACH_PER_PIXEL = 12L
    }
}

/**
 * The options of `zcli report`.
 *
 * @property compared what is compared, without views
 * @property command the command line that makes the report, without the output
 */
internal class ReportRequest(
    val shown: ShownInput,
    val output: Path,
    val compared: CompareRequest,
    val command: String,
)

/**
 * What is seen of a rendering besides its cost.
 *
 * @property image the pixels
 * @property calls the number of shading calls of each pixel
 * @property order the shading calls in their order, if samples are pixels and there are not too many
 */
internal class Portrait(val image: Image, val calls: AovImage, val order: OrderMap?) {
    /** See [Image.pixelHash]. */
    val hash: String = image.pixelHash()
}

/**
 * What a report says about one strategy.
 *
 * @property outcome the result of the comparison; failed if the [portrait] could not be made
 * @property portrait there if the strategy has rendered
 */
internal class ReportEntry(val id: String, val summary: String, val outcome: Outcome, val portrait: Portrait?) {
    /** What was measured, or null if there is no picture. */
    val rendered: Outcome.Rendered? get() = outcome as? Outcome.Rendered

    /** Why there is no picture, in a few words; empty if there is one. */
    val obstacle: String
        get() = when (outcome) {
            is Outcome.NotBlending -> "does not blend"
            is Outcome.Failed -> "failed"
            is Outcome.Rendered -> ""
        }
}

/**
 * The content of a report: one input, rendered with all strategies.
 *
 * @property comparison times, counters and differences
 * @property entries one for each strategy, in their order
 * @property overdraw the fragments of each pixel, for all strategies the same; null if all failed
 * @property parts what is visible of each surface
 */
internal class Report(
    val input: String,
    val command: String,
    val comparison: Comparison,
    val entries: List<ReportEntry>,
    val overdraw: AovImage?,
    val parts: List<VisibleObject>,
) {
    /** The pixel hash of the picture with which all others are compared, or null if all strategies failed. */
    val hash: String? = comparison.reference?.image?.pixelHash()

    /** The shortest time of a strategy, in nanoseconds, at least 1. */
    val fastest: Long = maxOf(entries.mapNotNull { it.rendered?.nanoseconds }.minOrNull() ?: 1, 1)

    /** Returns whether [entry] has the picture of the others: each time it was compared, and in this report. */
    fun isIdentical(entry: ReportEntry): Boolean =
        entry.rendered != null && entry.rendered?.difference == null && entry.portrait?.hash == hash

    /** The strategies that rendered, or failed to. */
    val tried: List<ReportEntry> get() = entries.filter { it.outcome !is Outcome.NotBlending }

    /** Whether no strategy failed, and all pictures are equal. */
    val isGood: Boolean get() = tried.all { isIdentical(it) }

    /** See [Comparison.bugs]. */
    val bugs: List<Throwable> get() = Comparison.bugs(entries.map { it.id to it.outcome })

    /** The result in one line. */
    val verdict: String
        get() {
            val pixels = comparison.shot.pixels
            val equal = tried.count { isIdentical(it) }
            val skipped = entries.size - tried.size
            val rest = if (skipped == 0) "" else "; $skipped cannot blend translucent surfaces"
            val size = counted(pixels.size, "pixel")
            val result = when {
                isGood && equal == 1 -> "Only one strategy, so nothing was compared; $size"
                isGood -> "Identical: all $equal strategies give the same bits at all $size"
                else -> "Not identical: $equal of ${tried.size} strategies give the same bits at all $size"
            }
            return "$result, pixel hash ${hash ?: "none"}$rest"
        }
}
