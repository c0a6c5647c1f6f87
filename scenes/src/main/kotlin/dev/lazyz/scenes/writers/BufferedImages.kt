@file:JvmName("BufferedImages")

package dev.lazyz.scenes.writers

import dev.lazyz.Image
import java.awt.image.BufferedImage

/**
 * Returns the colours as a picture for `java.desktop`, of type [BufferedImage.TYPE_INT_ARGB]; a copy. Java:
 * `BufferedImages.toBufferedImage(image)`.
 */
public fun Image.toBufferedImage(): BufferedImage {
    val picture = BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB)
    picture.raster.setDataElements(0, 0, width, height, argb)
    return picture
}
