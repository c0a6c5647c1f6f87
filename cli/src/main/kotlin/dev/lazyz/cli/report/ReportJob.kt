package dev.lazyz.cli.report

import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImages
import dev.lazyz.cli.compare.CompareJob
import dev.lazyz.cli.compare.CompareRequest
import dev.lazyz.cli.compare.Outcome
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.ReportPlace
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.trace.ShadingOrder
import dev.lazyz.scenes.aov.ObjectTable
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.pictures.PictureFrame
import java.nio.file.Path

/** One run of `zcli report`: compares, renders once more to see where the work is, and writes the page. */
internal class ReportJob(private val request: ReportRequest, private val streams: Streams) {
    private val choices = request.compared.choices

    fun run(): Report {
        // Report mistakes in the options before anything is read
        val page = ReportPlace(request.output, "-o").page
        val source = FrameSource(request.subject, streams)
        val replaced = OutputPlaces(listOf("-o" to page))
        request.subject.requireKept(replaced)
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
internal class ReportRequest(val subject: Subject, val output: Path, val compared: CompareRequest, val command: String,)
