package dev.lazyz.cli.trace

import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Tally
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.render.FanOut
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.writers.AlphaChannel
import java.nio.file.Path

/** One run of `zcli trace`: reads, sets up, renders with each strategy, and writes the film. */
internal class TraceJob(private val request: TraceRequest, private val streams: Streams) {
    fun run() {
        // Report mistakes in the options before anything is read
        OutputFile.check(request.output, "-o", ENDINGS)
        if (request.strategies.size > 2) throw Mistake("--strategy: a film shows one strategy or two")
        if (request.strategies.distinct().size < request.strategies.size) {
            throw Mistake("--strategy: '${request.strategies[0]}' is named twice")
        }
        val choices = request.choices.sharing(1)
        val named = request.strategies.ifEmpty { listOf(null) }.map { StrategyChoice(it, choices) }
        val source = FrameSource(request.shown, streams)
        val replaced = OutputPlaces(listOf("-o" to request.output))
        request.shown.requireKept(replaced)

        val loaded = source.load()
        source.requireKept(loaded, replaced)
        val shot = source.frame(loaded, choices.options())
        if (!shot.isPlain) throw Mistake("a film shows shading calls as pixels; use --aa 1 and --aa-filter box")
        val strategies = named.map { it.strategyFor(shot.frame) }
        for (strategy in strategies) Strategies.requireMemory(strategy, shot.frame.region, kept = BYTES_PER_PIXEL)
        val picture = TracedPicture(shot.pixels)
        val tally = Tally(shot.pixels.width, isHashed = false)

        // A film that is too large is refused before anything is recorded
        val isPage = request.output.toString().endsWith(PAGE, ignoreCase = true)
        val film = if (isPage) null else film(strategies.size, picture)
        val all = FanOut(listOf(picture, tally))
        val orders = strategies.mapIndexed { number, it -> record(it, shot, if (number == 0) all else picture) }
        request.blanks.report(tally.blank, streams)

        streams.progress("writing ${request.output} ...")
        if (film == null) {
            FilmPage(orders, picture, source.input.name, request.steps, request.framesPerSecond).write(request.output)
        } else {
            if (shot.alpha == AlphaChannel.KEEP) {
                streams.warning("a film has no alpha: what is transparent is shown as opaque; use .html")
            }
            film.write(orders)
        }
        for (order in orders) {
            val calls = counted(order.size.toLong(), "shading call")
            streams.print("${order.strategy}: $calls, %,d of them discarded\n".format(null, order.discarded))
        }
        streams.remark("wrote ${request.output}")
    }

    private fun film(panels: Int, picture: TracedPicture) =
        Film(request.output, panels, picture, request.steps, request.framesPerSecond)

    private fun record(strategy: Renderer, shot: PictureFrame, picture: RowSink): ShadingOrder {
        streams.progress("rendering with ${strategy.id} ...")
        val recorder = ShadingOrder.Recorder(shot.frame, strategy.id)
        shot.observed(recorder).render(strategy, picture)
        return recorder.toOrder()
    }

    companion object {
        /** Colours, here and in a film, and what finds the discarded calls. */
        private const val BYTES_PER_PIXEL = 20L

        /** The ending of files that are pages. */
        private const val PAGE = ".html"

        /** The endings of files that can be written. */
        val ENDINGS = listOf(".gif", ".png", ".apng", PAGE)
    }
}

/**
 * The options of `zcli trace`.
 *
 * @property strategies ids of one strategy or two; if empty, the usual one
 * @property steps pictures from the first call to the last
 * @property blanks what happens if the picture is blank
 */
internal class TraceRequest(
    val shown: ShownInput,
    val output: Path,
    val strategies: List<String>,
    val choices: Choices,
    val steps: Int,
    val framesPerSecond: Int,
    val blanks: BlankPictures,
)
