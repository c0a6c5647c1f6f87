@file:JvmName("BufferedImages")

package dev.lazyz.scenes.writers

import dev.lazyz.Image
import java.awt.image.BufferedImage

/**
 * Returns a copy of the colours as a `java.desktop` image of type [BufferedImage.TYPE_INT_ARGB]. In Java:
 * `BufferedImages.toBufferedImage(image)`.
 */
public fun Image.toBufferedImage(): BufferedImage {
    val picture = BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB)
    picture.raster.setDataElements(0, 0, width, height, argb)
    return picture
}
