package dev.lazyz.scenes.images

import java.awt.image.BufferedImage
import java.awt.image.IndexColorModel
import java.awt.image.Raster

/**
 * Converts images to `0xAARRGGBB` texels, directly from the numbers that the file stores.
 *
 * There is no colour management: codes are taken as sRGB, whatever profile or gamma the file states.
 * `BufferedImage.getRGB` is not suitable, because it treats grey as linear light, which turns 128 into 188, and
 * converts from profiles in floating point.
 */
internal object Texels {
    /** Returns the texels of [image] in rows from the top. */
    fun of(image: BufferedImage): IntArray {
        val palette = image.colorModel as? IndexColorModel
        val raster = image.raster
        val bits = raster.sampleModel.sampleSize
        val bands = raster.numBands
        val row = IntArray(image.width * bands)
        val argb = IntArray(image.width * image.height)
        for (y in 0 until image.height) {
            readRow(raster, y, row)
            for (x in 0 until image.width) {
                val at = x * bands
                argb[y * image.width + x] = when {
                    palette != null -> palette.getRGB(row[at])
                    bands <= 2 -> grey(byte(row[at], bits[0]), if (bands == 2) byte(row[at + 1], bits[1]) else 0xFF)
                    else -> {
                        val alpha = if (bands == 4) byte(row[at + 3], bits[3]) else 0xFF
                        argb(alpha, byte(row[at], bits[0]), byte(row[at + 1], bits[1]), byte(row[at + 2], bits[2]))
                    }
                }
            }
        }
        return argb
    }

    private fun readRow(raster: Raster, y: Int, row: IntArray) {
        raster.getPixels(raster.minX, raster.minY + y, raster.width, 1, row)
    }

    /** Scales a sample of any bit depth to 0..255, rounded to the nearest. */
    private fun byte(sample: Int, bits: Int): Int {
        if (bits == 8) return sample
        val most = (1L shl bits) - 1
        return ((sample.toLong() * 255 + most / 2) / most).toInt()
    }

    private fun grey(level: Int, alpha: Int): Int = argb(alpha, level, level, level)

    private fun argb(alpha: Int, red: Int, green: Int, blue: Int): Int =
        alpha shl 24 or (red shl 16) or (green shl 8) or blue
}
