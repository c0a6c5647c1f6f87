package dev.lazyz.cli

import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.imageio.metadata.IIOMetadataNode
import kotlin.io.path.readBytes

/** What is seen in each frame of an opaque animated GIF, whose frames are drawn over those before. */
internal fun Path.gifFrames(): List<BufferedImage> {
    val reader = ImageIO.getImageReadersByFormatName("gif").next()
    reader.input = ImageIO.createImageInputStream(ByteArrayInputStream(readBytes()))
    val count = reader.getNumImages(true)
    val canvas = BufferedImage(reader.getWidth(0), reader.getHeight(0), BufferedImage.TYPE_INT_ARGB)
    return List(count) {
        val metadata = reader.getImageMetadata(it)
        val root = metadata.getAsTree(metadata.nativeMetadataFormatName) as IIOMetadataNode
        val place = root.getElementsByTagName("ImageDescriptor").item(0) as IIOMetadataNode
        val (x, y) = listOf("Left", "Top").map { side -> place.getAttribute("image${side}Position").toInt() }
        canvas.createGraphics().drawImage(reader.read(it), x, y, null)
        BufferedImage(canvas.colorModel, canvas.copyData(null), false, null)
    }
}
