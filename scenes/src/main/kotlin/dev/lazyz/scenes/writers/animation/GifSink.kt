package dev.lazyz.scenes.writers.animation

import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.RowOrder
import java.awt.image.BufferedImage
import java.awt.image.DataBufferByte
import java.awt.image.IndexColorModel
import java.io.Closeable
import java.io.IOException
import java.io.OutputStream
import java.util.Arrays
import javax.imageio.IIOImage
import javax.imageio.ImageIO
import javax.imageio.ImageTypeSpecifier
import javax.imageio.ImageWriter
import javax.imageio.metadata.IIOMetadata
import javax.imageio.metadata.IIOMetadataNode
import javax.imageio.stream.MemoryCacheImageOutputStream

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

/**
 * Writes frames as an animated GIF, with one palette for all, by the writer of `javax.imageio`. Of an opaque frame,
 * only the rectangle is written in which it differs from the frame before.
 */
internal class GifEncoder(
    private val output: OutputStream,
    private val animation: Animation,
    private val palette: Palette,
) {
    private val colorModel = colorModel()
    private val whole = Region(0, 0, animation.width, animation.height)

    fun write(frames: List<IntArray>) {
        val writer = ImageIO.getImageWritersByFormatName("gif").next()
        try {
            MemoryCacheImageOutputStream(output).use { stream ->
                writer.output = stream
                writer.prepareWriteSequence(streamMetadata(writer))
                var before: ByteArray? = null
                for ((number, frame) in frames.withIndex()) {
                    val colors = palette.numbersOf(frame)
                    val part = if (before == null || palette.transparent >= 0) whole else changed(before, colors)
                    writer.writeToSequence(image(writer, number, colors, part), null)
                    before = colors
                }
                writer.endWriteSequence()
            }
        } finally {
            writer.dispose()
        }
        output.flush()
    }

    private fun colorModel(): IndexColorModel {
        val channels = List(ColorHistogram.CHANNELS) { channel ->
            ByteArray(palette.size).also { values ->
                for ((i, color) in palette.colors.withIndex()) {
                    values[i] = ColorHistogram.channel(color, channel).toByte()
                }
            }
        }
        return IndexColorModel(8, palette.size, channels[0], channels[1], channels[2], palette.transparent)
    }

    /** Returns the smallest rectangle outside which two frames are the same; one pixel if they are the same. */
    private fun changed(before: ByteArray, now: ByteArray): Region {
        var part: Region? = null
        for (y in 0 until animation.height) {
            val row = y * animation.width
            val first = Arrays.mismatch(before, row, row + animation.width, now, row, row + animation.width)
            if (first < 0) continue
            var end = animation.width
            while (before[row + end - 1] == now[row + end - 1]) end--
            val changes = Region(first, y, end, y + 1)
            part = part?.union(changes) ?: changes
        }
        return part ?: Region(0, 0, 1, 1)
    }

    private fun image(writer: ImageWriter, number: Int, colors: ByteArray, part: Region): IIOImage {
        val image = BufferedImage(part.width, part.height, BufferedImage.TYPE_BYTE_INDEXED, colorModel)
        val target = (image.raster.dataBuffer as DataBufferByte).data
        for (y in 0 until part.height) {
            val from = (part.rowStart + y) * animation.width + part.columnStart
            colors.copyInto(target, y * part.width, from, from + part.width)
        }
        return IIOImage(image, null, frameMetadata(writer, number, part))
    }

    /** The logical screen has the palette of all frames, so that no frame repeats it. */
    private fun streamMetadata(writer: ImageWriter): IIOMetadata {
        val metadata = writer.getDefaultStreamMetadata(null)
        val format = metadata.nativeMetadataFormatName
        val root = metadata.getAsTree(format) as IIOMetadataNode
        val screen = root.child("LogicalScreenDescriptor")
        screen.setAttribute("logicalScreenWidth", "${animation.width}")
        screen.setAttribute("logicalScreenHeight", "${animation.height}")
        val entries = 1 shl maxOf(1, Int.SIZE_BITS - (palette.size - 1).countLeadingZeroBits())
        val table = root.child("GlobalColorTable")
        table.setAttribute("sizeOfGlobalColorTable", "$entries")
        table.setAttribute("backgroundColorIndex", "0")
        table.setAttribute("sortFlag", "FALSE")
        for (i in 0 until entries) {
            val color = palette.colors.getOrElse(i) { 0 }
            val entry = IIOMetadataNode("ColorTableEntry").apply { setAttribute("index", "$i") }
            for ((channel, name) in listOf("red", "green", "blue").withIndex()) {
                entry.setAttribute(name, "${ColorHistogram.channel(color, channel)}")
            }
            table.appendChild(entry)
        }
        metadata.setFromTree(format, root)
        return metadata
    }

    private fun frameMetadata(writer: ImageWriter, number: Int, part: Region): IIOMetadata {
        val type = ImageTypeSpecifier(colorModel, colorModel.createCompatibleSampleModel(1, 1))
        val metadata = writer.getDefaultImageMetadata(type, null)
        val format = metadata.nativeMetadataFormatName
        val root = metadata.getAsTree(format) as IIOMetadataNode
        root.getElementsByTagName("LocalColorTable").item(0)?.let { root.removeChild(it) }
        val descriptor = root.child("ImageDescriptor")
        descriptor.setAttribute("imageLeftPosition", "${part.columnStart}")
        descriptor.setAttribute("imageTopPosition", "${part.rowStart}")
        descriptor.setAttribute("interlaceFlag", "FALSE")
        val control = root.child("GraphicControlExtension")
        val isTransparent = palette.transparent >= 0
        control.setAttribute("disposalMethod", if (isTransparent) "restoreToBackgroundColor" else "doNotDispose")
        control.setAttribute("userInputFlag", "FALSE")
        control.setAttribute("transparentColorFlag", if (isTransparent) "TRUE" else "FALSE")
        control.setAttribute("transparentColorIndex", "${maxOf(palette.transparent, 0)}")
        control.setAttribute("delayTime", "${ending(number) - ending(number - 1)}")
        if (number == 0) root.child("ApplicationExtensions").appendChild(endlessLoop())
        metadata.setFromTree(format, root)
        return metadata
    }

    /** When the frame with this number ends, in hundredths of a second. */
    private fun ending(number: Int): Int = (100L * (number + 1) / animation.framesPerSecond).toInt()

    private fun endlessLoop() = IIOMetadataNode("ApplicationExtension").apply {
        setAttribute("applicationID", "NETSCAPE")
        setAttribute("authenticationCode", "2.0")
        userObject = byteArrayOf(1, 0, 0)
    }

    private fun IIOMetadataNode.child(name: String): IIOMetadataNode =
        getElementsByTagName(name).item(0) as IIOMetadataNode? ?: IIOMetadataNode(name).also { appendChild(it) }
}
