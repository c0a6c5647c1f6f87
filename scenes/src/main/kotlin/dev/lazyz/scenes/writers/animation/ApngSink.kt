package dev.lazyz.scenes.writers.animation

import dev.lazyz.RowSink
import dev.lazyz.scenes.writers.PngBlocks
import dev.lazyz.scenes.writers.PngChunks
import dev.lazyz.scenes.writers.RowOrder
import dev.lazyz.scenes.writers.channels
import java.io.ByteArrayOutputStream
import java.io.Closeable
import java.io.IOException
import java.io.OutputStream
import java.nio.ByteBuffer

/**
 * Writes an animated PNG as rows arrive: the rows of all frames, one frame after the other, each from the top.
 *
 * Frames are compressed as by `PngSink`, on the threads of the common pool, with the same bytes for any number of
 * threads. Memory does not grow with the number of frames. Programs that do not know animated PNGs show the first
 * frame. Call [close] after the last row, otherwise the file is incomplete; it also closes the stream. Not thread safe.
 *
 * Source: "Portable Network Graphics (PNG) Specification", third edition, W3C, section 11.3.6.
 *
 * @param output the target; need not be buffered
 * @param animation size and number of the frames
 * @throws IOException if the beginning of the file cannot be written
 */
public class ApngSink
@Throws(IOException::class)
constructor(
    private val output: OutputStream,
    private val animation: Animation
) : RowSink,
    Closeable {
    private val chunks = PngChunks(output)
    private val compressed = ByteArrayOutputStream()
    private var blocks: PngBlocks? = null
    private var order = RowOrder(animation.width, animation.height)
    private var frame = 0
    private var sequence = 0
    private var isClosed = false

    init {
        chunks.describe(animation.width, animation.height, animation.alpha)
        chunks.write("acTL", ByteBuffer.allocate(8).putInt(animation.frames).putInt(ENDLESS).array())
    }

    /**
     * Writes row [y] of the current frame; depth and primitive are ignored.
     *
     * @throws IllegalArgumentException if [y] does not follow the previous row of the frame (the first row may have any
     *   number from 0 on), the row is too short, or all frames are complete
     * @throws IOException if writing to the stream fails
     */
    @Throws(IOException::class)
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        require(frame < animation.frames) { "there are only ${animation.frames} frames" }
        order.take(y, argb)
        val current = blocks ?: begin()
        current.add(argb)
        if (order.taken == animation.height) end()
    }

    /**
     * Writes the end of the file and closes the stream. Closing again does nothing.
     *
     * @throws IOException if rows are missing, or writing to the stream fails; the stream is closed anyway
     */
    @Throws(IOException::class)
    override fun close() {
        if (isClosed) return
        isClosed = true
        output.use {
            if (frame < animation.frames) {
                throw IOException("the animation is incomplete: $frame of ${animation.frames} frames")
            }
            chunks.write(PngChunks.END, ByteArray(0))
            output.flush()
        }
    }

    override fun toString(): String = "ApngSink($animation, $frame frames written)"

    private fun begin(): PngBlocks {
        val control = ByteBuffer.allocate(26).putInt(sequence++).putInt(animation.width).putInt(animation.height)
        control.putInt(0).putInt(0).putShort(1).putShort(animation.framesPerSecond.toShort())
        chunks.write("fcTL", control.put(KEEP_FRAME).put(REPLACE_PIXELS).array())
        val begun = PngBlocks(animation.width, animation.height, animation.alpha.channels) { take(it) }
        blocks = begun
        return begun
    }

    private fun end() {
        writeCompressed()
        blocks = null
        order = RowOrder(animation.width, animation.height)
        frame++
    }

    private fun take(data: ByteArray) {
        compressed.writeBytes(data)
        if (compressed.size() >= PngChunks.DATA_SIZE) writeCompressed()
    }

    /** The first frame is the picture that other programs show; the data of later ones is numbered. */
    private fun writeCompressed() {
        if (compressed.size() == 0) return
        if (frame == 0) {
            chunks.write(PngChunks.DATA, compressed.toByteArray())
        } else {
            val data = ByteBuffer.allocate(Int.SIZE_BYTES + compressed.size())
            chunks.write("fdAT", data.putInt(sequence++).put(compressed.toByteArray()).array())
        }
        compressed.reset()
    }

    private companion object {
        const val ENDLESS = 0
        const val KEEP_FRAME: Byte = 0
        const val REPLACE_PIXELS: Byte = 0
    }
}
