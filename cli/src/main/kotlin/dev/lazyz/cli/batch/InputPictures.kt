package dev.lazyz.cli.batch

import dev.lazyz.Counters
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.Statistics
import dev.lazyz.cli.output.StatisticsTable
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Tally
import dev.lazyz.cli.render.ColorRows
import dev.lazyz.cli.render.FanOut
import dev.lazyz.cli.render.PictureFile
import dev.lazyz.cli.render.StatsForm
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.scenes.writers.animation.AnimationFiles
import java.nio.file.Path

/**
 * Renders the pictures of the scene [loaded] from [source], and writes them.
 *
 * @param count is called with the number of each picture that is done, from 0
 * @param requireMemory throws if there is too little memory for a picture
 */
internal class InputPictures(
    private val request: BatchRequest,
    private val plan: BatchPlan,
    private val shares: Shares,
    private val source: FrameSource,
    private val loaded: LoadedScene,
    private val streams: Streams,
    private val count: (Int) -> Unit,
    private val requireMemory: (Renderer, PictureFrame) -> Unit,
) {
    private var done = 0

    /** Renders the pictures of [view]; appends their statistics, and the files that are complete. */
    fun render(view: ViewPlan, statistics: StringBuilder, files: MutableList<Path>) {
        view.files.forEach { OutputFile.createFolder(it) }
        val pictures = Pictures(view, statistics)
        when (plan.kind) {
            Kind.STILLS -> for ((frame, file) in view.files.withIndex()) {
                if (PictureFile.isDrawing(file)) draw(view, file) else still(view, frame, file, pictures)
                files.add(file)
            }

            Kind.ANIMATIONS -> {
                animate(view.files.single(), pictures)
                files.add(view.files.single())
            }

            Kind.SHEET -> repeat(plan.frames) { frame ->
                pictures.render(frame) { shot, render ->
                    val colors = ColorRows(shot.pixels)
                    render(colors)
                    shares.sheet?.put(view.firstCell + frame, colors.argb)
                }
            }
        }
    }

    private fun still(view: ViewPlan, frame: Int, file: Path, pictures: Pictures) {
        pictures.render(frame) { shot, render ->
            val warnings = PictureFile.warnings(file, shot.pixels, shot.alpha)
            warnings.forEach { streams.warning(view.labels[frame], it) }
            PictureFile.write(file, shot.pixels, shot.alpha, render)
        }
    }

    private fun draw(view: ViewPlan, file: Path) = shares.threads.forPicture { threads ->
        val choices = request.choices.sharing(threads)
        val label = view.labels.single()
        val drawing = source.drawing(loaded, choices.options(), view.view, label)
        val choice = StrategyChoice(request.strategy, choices)
        drawing.picture?.let { requireMemory(choice.strategyFor(it.frame), it) }
        request.blanks.report(BlankPictures.reason(PictureFile.write(file, drawing, choice)), streams, label)
        count(done++)
    }

    private fun animate(file: Path, pictures: Pictures) {
        val first = pictures.setUp(0)
        val speed = request.series.framesPerSecond ?: Animation.DEFAULT_FRAMES_PER_SECOND
        val animation = Animation(first.pixels.width, first.pixels.height, plan.frames, speed, first.alpha)
        AnimationFiles.write(file, animation) { sink ->
            repeat(plan.frames) { frame ->
                pictures.render(frame, if (frame == 0) first else null) { _, render -> render(sink) }
            }
        }
    }

    /** The pictures from one side. */
    private inner class Pictures(private val view: ViewPlan, private val statistics: StringBuilder) {
        private val settings = source.settings(view.view)
        private val turntable = request.series.turntable?.let { settings.turntable(loaded, it) }

        fun setUp(frame: Int): PictureFrame = shares.threads.forPicture { threads -> setUp(frame, threads) }

        private fun setUp(frame: Int, threads: Int): PictureFrame {
            val options = request.choices.sharing(threads).options()
            val observer = source.observer(view.labels[frame])
            val shot =
                turntable?.frame(frame, options, observer) ?: settings.frame(loaded, options, observer)
            requireMemory(strategy(shot, threads), shot)
            return shot
        }

        private fun strategy(shot: PictureFrame, threads: Int): Renderer =
            StrategyChoice(request.strategy, request.choices.sharing(threads)).strategyFor(shot.frame)

        /** Sets a picture up, unless it is [ready], and calls [write] with it and a function that renders it. */
        fun render(frame: Int, ready: PictureFrame? = null, write: (PictureFrame, (RowSink) -> Unit) -> Unit) {
            shares.threads.forPicture { threads ->
                val start = System.nanoTime()
                val shot = ready ?: setUp(frame, threads)
                val strategy = strategy(shot, threads)
                val tally = Tally(shot.pixels.width, request.stats != null)
                var counters = Counters.NONE
                write(shot) { sink -> counters = shot.render(strategy, FanOut(listOf(sink, tally))) }
                val nanoseconds = System.nanoTime() - start
                request.blanks.report(tally.blank, streams, view.labels[frame])
                if (request.stats != null) {
                    statistics.append(
                        text(
                            Statistics(
                                source.input.name, strategy, shot.pixels, shot, counters, tally,
                                loaded.warnings.size, nanoseconds, place(frame),
                            ),
                        ),
                    )
                }
            }
            count(done++)
        }

        private fun text(all: Statistics): String =
            if (request.stats == StatsForm.JSON) all.toJson() + "\n" else StatisticsTable.of(all)

        private fun place(frame: Int): Map<String, Any> = listOfNotNull(
            view.view?.let { "view" to it.name.lowercase() },
            if (turntable == null) null else "frame" to frame + 1,
            "output" to "${view.files.getOrNull(frame) ?: view.files.singleOrNull() ?: plan.sheet}",
        ).toMap()
    }
}
