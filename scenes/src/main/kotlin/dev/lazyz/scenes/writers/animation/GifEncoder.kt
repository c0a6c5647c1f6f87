package dev.lazyz.scenes.writers.animation

import java.awt.image.BufferedImage
import java.awt.image.DataBufferByte
import java.awt.image.IndexColorModel
import java.io.OutputStream
import javax.imageio.IIOImage
import javax.imageio.ImageIO
import javax.imageio.ImageTypeSpecifier
import javax.imageio.ImageWriter
import javax.imageio.metadata.IIOMetadata
import javax.imageio.metadata.IIOMetadataNode
import javax.imageio.stream.MemoryCacheImageOutputStream

/** Writes frames as an animated GIF, with one palette for all, by the writer of `javax.imageio`. */
internal class GifEncoder(
    private val output: OutputStream,
    private val animation: Animation,
    private val palette: Palette,
) {
    private val colorModel = colorModel()

    fun write(frames: List<IntArray>) {
        val writer = ImageIO.getImageWritersByFormatName("gif").next()
        try {
            MemoryCacheImageOutputStream(output).use { stream ->
                writer.output = stream
                writer.prepareWriteSequence(streamMetadata(writer))
                for ((number, frame) in frames.withIndex()) writer.writeToSequence(image(writer, number, frame), null)
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

    private fun image(writer: ImageWriter, number: Int, frame: IntArray): IIOImage {
        val image =
            BufferedImage(animation.width, animation.height, BufferedImage.TYPE_BYTE_INDEXED, colorModel)
        palette.numbersOf(frame).copyInto((image.raster.dataBuffer as DataBufferByte).data)
        return IIOImage(image, null, frameMetadata(writer, number))
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

    private fun frameMetadata(writer: ImageWriter, number: Int): IIOMetadata {
        val type = ImageTypeSpecifier(colorModel, colorModel.createCompatibleSampleModel(1, 1))
        val metadata = writer.getDefaultImageMetadata(type, null)
        val format = metadata.nativeMetadataFormatName
        val root = metadata.getAsTree(format) as IIOMetadataNode
        root.getElementsByTagName("LocalColorTable").item(0)?.let { root.removeChild(it) }
        root.child("ImageDescriptor").setAttribute("interlaceFlag", "FALSE")
        val control = root.child("GraphicControlExtension")
        val isTransparent = palette.transparent >= 0
        control.setAttribute("disposalMethod", if (isTransparent) "restoreToBackgroundColor" else "none")
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
