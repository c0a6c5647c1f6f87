package dev.lazyz.cli.trace

import dev.lazyz.RowSink
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.scenes.pictures.Canvas
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.scenes.writers.animation.AnimationFiles
import dev.lazyz.scenes.writers.animation.AnimationFormat
import dev.lazyz.scenes.writers.sendTo
import java.nio.file.Path

/**
 * An animation at [path] of how the shading calls of one or more strategies make one [picture], side by side on the
 * same clock: all have made as many calls, or are done.
 *
 * @param panels the number of strategies
 * @param steps pictures from the first call to the last of the longest order
 * @throws Mistake if it does not fit into memory
 */
internal class Film(
    private val path: Path,
    panels: Int,
    private val picture: TracedPicture,
    private val steps: Int,
    framesPerSecond: Int,
) {
    private val pause = framesPerSecond * PAUSE_SECONDS
    private val animation = Animation(
        panels * (FilmPanel.width(picture) + GAP) - GAP, FilmPanel.height(picture),
        steps + pause, framesPerSecond, AlphaChannel.DROP,
    )

    init {
        val format = AnimationFiles.formatOf(path)
        format.obstacle(animation.width, animation.height)?.let {
            throw Mistake("a film of this picture cannot be written: $it; choose a smaller --size, or write a .png")
        }
        val kept = if (format == AnimationFormat.GIF) animation.frames else 1
        val bytes = 4L * kept * animation.width * animation.height
        val available = Runtime.getRuntime().maxMemory()
        if (bytes > available / 2) {
            throw Mistake(
                "a film of ${animation.frames} pictures of ${animation.width}x${animation.height} needs " +
                    "${Bytes.readable(bytes)} of memory, and a film may use half of the ${Bytes.readable(available)} " +
                    "that Java may use; choose a smaller --size or fewer --steps" +
                    if (kept > 1) ", or write a .png" else "",
            )
        }
    }

    /** Writes the film of these [orders] of the finished picture, one for each panel. */
    fun write(orders: List<ShadingOrder>) {
        val panels = orders.map { FilmPanel(it, picture) }
        val most = orders.maxOf { it.size }
        AnimationFiles.write(path, animation) { sink ->
            for (step in 1..steps) draw(panels, (most.toLong() * step / steps).toInt(), sink)
            repeat(pause) { draw(panels, most, sink) }
        }
    }

    private fun draw(panels: List<FilmPanel>, calls: Int, sink: RowSink) {
        val canvas = Canvas(animation.width, animation.height, PAGE)
        var left = 0
        for (panel in panels) {
            panel.advance(calls)
            panel.draw(canvas, left)
            left += FilmPanel.width(picture) + GAP
        }
        canvas.toImage().sendTo(sink)
    }

    companion object {
        /** How long the final picture is shown. */
        const val PAUSE_SECONDS = 1
        private const val PAGE = -1
        private const val GAP = 8
    }
}
