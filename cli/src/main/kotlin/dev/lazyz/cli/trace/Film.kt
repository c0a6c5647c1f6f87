package dev.lazyz.cli.trace

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Region
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
import java.util.BitSet

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

/** Keeps the final picture of [region], opaque: before white if its background is not. */
internal class TracedPicture(private val region: Region) : RowSink {
    val width: Int get() = region.width
    val height: Int get() = region.height

    /** The colours in rows from the top, `0xAARRGGBB`. */
    val argb = IntArray(Math.toIntExact(region.size))

    /** The pixels at which a surface is visible. */
    val covered = BitSet(argb.size)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val first = (y - region.rowStart) * width
        for (x in 0 until width) {
            this.argb[first + x] = beforeWhite(argb[x])
            if (primitive[x] != DepthTest.BACKGROUND) covered.set(first + x)
        }
    }

    /** Returns the picture, without copying its colours. It has no depth. */
    fun toImage(): Image = Image(
        width, height, argb, IntArray(argb.size), IntArray(argb.size) { DepthTest.BACKGROUND }, Counters.NONE,
    )

    private fun beforeWhite(color: Int): Int {
        val alpha = color ushr 24
        fun channel(shift: Int) = ((color shr shift and 0xFF) * alpha + 255 * (255 - alpha) + 127) / 255 shl shift
        return 0xFF shl 24 or channel(16) or channel(8) or channel(0)
    }
}
