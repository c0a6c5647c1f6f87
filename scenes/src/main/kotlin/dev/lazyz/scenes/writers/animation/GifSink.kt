package dev.lazyz.scenes.writers.animation

import dev.lazyz.RowSink
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.RowOrder
import java.io.Closeable
import java.io.IOException
import java.io.OutputStream

/**
 * Collects the rows of all frames, one frame after the other, each from the top, and writes them as an animated GIF.
 *
 * All frames share one palette of at most 256 colours, so that nothing flickers. It is exact if the frames have so few
 * colours; otherwise the colours are chosen by their frequency and variance (median cut), and the upper left pixel of
 * the first frame, usually the background, stays exact. Pixels are not dithered. With [AlphaChannel.KEEP], a pixel is
 * transparent if its alpha is below one half; otherwise it is opaque. The palette is computed with integers in a fixed
 * order, so it is the same on every machine.
 *
 * Of an opaque frame, only the rectangle is stored in which it differs from the frame before.
 *
 * A frame is shown for a whole number of hundredths of a second, alternately less and more if needed. Memory: 4 bytes
 * for each pixel of all frames. Nothing is written before [close], which also closes the stream. Not thread safe.
 *
 * Source: "Graphics Interchange Format, Version 89a", CompuServe; Paul Heckbert, "Color Image Quantization for Frame
 * Buffer Display", SIGGRAPH 1982 (boxes are split by variance here, not by size).
 *
 * @param output the target; need not be buffered
 * @param animation size and number of the frames; a side is at most 65,535
 * @throws IllegalArgumentException if a side is too long, or a frame has more pixels than an array
 */
public class GifSink(private val output: OutputStream, private val animation: Animation) :
    RowSink,
    Closeable {
    private val frames = ArrayList<IntArray>()
    private var order = RowOrder(animation.width, animation.height)
    private var isClosed = false

    init {
        val obstacle = AnimationFormat.GIF.obstacle(animation.width, animation.height)
        require(obstacle == null) { "$obstacle" }
    }

    /**
     * Keeps row [y] of the current frame; depth and primitive are ignored.
     *
     * @throws IllegalArgumentException if [y] does not follow the previous row of the frame (the first row may have any
     *   number from 0 on), the row is too short, or all frames are complete
     */
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        if (frames.isEmpty() || order.taken == animation.height) {
            require(frames.size < animation.frames) { "there are only ${animation.frames} frames" }
            order = RowOrder(animation.width, animation.height)
            frames.add(IntArray(animation.width * animation.height))
        }
        order.take(y, argb)
        argb.copyInto(frames.last(), (order.taken - 1) * animation.width, 0, animation.width)
    }

    /**
     * Writes the file and closes the stream. Closing again does nothing.
     *
     * @throws IOException if rows are missing, or writing to the stream fails; the stream is closed anyway
     */
    @Throws(IOException::class)
    override fun close() {
        if (isClosed) return
        isClosed = true
        output.use {
            val complete = frames.size - (if (order.taken in 1 until animation.height) 1 else 0)
            if (complete < animation.frames) {
                throw IOException("the animation is incomplete: $complete of ${animation.frames} frames")
            }
            val colors = ColorHistogram()
            for (frame in frames) colors.add(frame, animation.alpha == AlphaChannel.KEEP)
            GifEncoder(output, animation, Palette.of(colors, frames[0][0])).write(frames)
        }
    }

    override fun toString(): String = "GifSink($animation, ${frames.size} frames)"
}
