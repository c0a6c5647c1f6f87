package dev.lazyz.scenes.images

import dev.lazyz.Rgba
import java.awt.color.ColorSpace
import java.awt.image.BufferedImage
import java.awt.image.IndexColorModel
import java.awt.image.Raster

/**
 * Converts images to pixels, directly from the numbers that the file stores.
 *
 * There is no colour management: codes are taken as sRGB, whatever profile or gamma the file states. Inks, CMYK, let
 * through what they do not absorb, each by itself: red is (1 - cyan) (1 - black).
 * `BufferedImage.getRGB` is not suitable, because it treats grey as linear light, which turns 128 into 188, and
 * converts from profiles in floating point.
 */
internal object Texels {
    private const val BYTE = 0xFF
    private const val WORD = 0xFFFF

    /**
     * Returns the pixels of [image] in rows from the top, 8 bits a channel, `0xAARRGGBB`.
     *
     * @param look called before each row; throws to end the reading
     */
    fun of(image: BufferedImage, look: () -> Unit = {}): IntArray {
        val argb = IntArray(image.width * image.height)
        read(image, BYTE, look) { at, alpha, red, green, blue ->
            argb[at] = alpha shl 24 or (red shl 16) or (green shl 8) or blue
        }
        return argb
    }

    /** Returns the pixels of [image] in rows from the top, 16 bits a channel, `0xAAAARRRRGGGGBBBB`. */
    fun wide(image: BufferedImage): LongArray {
        val argb = LongArray(image.width * image.height)
        read(image, WORD) { at, alpha, red, green, blue ->
            argb[at] = alpha.toLong() shl 48 or (red.toLong() shl 32) or (green.toLong() shl 16) or blue.toLong()
        }
        return argb
    }

    /** Returns whether a channel of [image] has more than 8 bits, so that [of] would round it. */
    fun isWide(image: BufferedImage): Boolean =
        image.colorModel !is IndexColorModel && image.raster.sampleModel.sampleSize.any { it > 8 }

    /** Calls [pixel] for each pixel of [image] with its index and its channels, scaled to 0..[most]. */
    private inline fun read(
        image: BufferedImage,
        most: Int,
        look: () -> Unit = {},
        pixel: (at: Int, alpha: Int, red: Int, green: Int, blue: Int) -> Unit,
    ) {
        val palette = image.colorModel as? IndexColorModel
        val isInk = image.colorModel.colorSpace.type == ColorSpace.TYPE_CMYK
        val raster = image.raster
        val bits = raster.sampleModel.sampleSize
        val bands = raster.numBands
        val row = IntArray(image.width * bands)
        for (y in 0 until image.height) {
            look()
            readRow(raster, y, row)
            for (x in 0 until image.width) {
                val from = x * bands
                val to = y * image.width + x
                when {
                    palette != null -> {
                        val argb = palette.getRGB(row[from])
                        val (red, green, blue) = listOf(argb ushr 16, argb ushr 8, argb)
                        pixel(to, code(argb ushr 24, most), code(red, most), code(green, most), code(blue, most))
                    }

                    bands <= 2 -> {
                        val level = scaled(row[from], bits[0], most)
                        pixel(to, if (bands == 2) scaled(row[from + 1], bits[1], most) else most, level, level, level)
                    }

                    isInk -> {
                        val black = scaled(row[from + 3], bits[3], most)
                        val (red, green, blue) = List(3) { left(scaled(row[from + it], bits[it], most), black, most) }
                        pixel(to, most, red, green, blue)
                    }

                    else -> pixel(
                        to,
                        if (bands == 4) scaled(row[from + 3], bits[3], most) else most,
                        scaled(row[from], bits[0], most),
                        scaled(row[from + 1], bits[1], most),
                        scaled(row[from + 2], bits[2], most),
                    )
                }
            }
        }
    }

    private fun readRow(raster: Raster, y: Int, row: IntArray) {
        raster.getPixels(raster.minX, raster.minY + y, raster.width, 1, row)
    }

    /** Returns the light that an [ink] and [black] leave of [most]. */
    private fun left(ink: Int, black: Int, most: Int): Int =
        (((most - ink).toLong() * (most - black) + most / 2) / most).toInt()

    /** Scales the last 8 bits of [argb] to 0..[most]. */
    private fun code(argb: Int, most: Int): Int = scaled(argb and BYTE, 8, most)

    /** Scales a sample of any bit depth to 0..[most], rounded to the nearest. */
    private fun scaled(sample: Int, bits: Int, most: Int): Int {
        val mostOfBits = (1L shl bits) - 1
        if (mostOfBits == most.toLong()) return sample
        return ((sample.toLong() * most + mostOfBits / 2) / mostOfBits).toInt()
    }
}

/** Converts 8-bit sRGB codes, as files store colours, to linear light. */
internal object SrgbDecoding {
    private val ofByte = FloatArray(256) { Rgba.linearOf(it / 255.0) }

    /** Decodes an 8-bit code, 0..255, to the same value that the core module gives a texel with this code. */
    fun decodeByte(code: Int): Float = ofByte[code]
}
