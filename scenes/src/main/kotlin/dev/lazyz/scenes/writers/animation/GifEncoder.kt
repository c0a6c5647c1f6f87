package dev.lazyz.scenes.writers.animation

import dev.lazyz.Region
import java.awt.image.BufferedImage
import java.awt.image.DataBufferByte
import java.awt.image.IndexColorModel
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
