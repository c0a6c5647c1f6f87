package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.bytes
import dev.lazyz.filter.LightSums
import dev.lazyz.filter.LightSums.CHANNELS

/**
 * The light of those pixels of a tile whose samples have several colours. Belongs to one thread; reused for each tile.
 *
 * @param pixels number of pixels of the largest tile
 */
internal class PixelSums(pixels: Int) {
    private val has = BooleanArray(pixels)
    private val sums = LongArray(CHANNELS * pixels)

    /** By pixel, the colour of its upper left sample. */
    private val corners = IntArray(pixels)
    private val all = IntArray(pixels)

    /** Number of pixels. */
    var count: Int = 0
        private set

    /** Bytes held. */
    val bytes: Long get() = has.size + sums.bytes + corners.bytes + all.bytes

    /** Removes all pixels. */
    fun clear() {
        has.fill(false)
        count = 0
    }

    /** Adds a [pixel] without colours. */
    fun begin(pixel: Int) {
        has[pixel] = true
        all[count++] = pixel
        sums.fill(0, CHANNELS * pixel, CHANNELS * (pixel + 1))
    }

    operator fun contains(pixel: Int): Boolean = has[pixel]

    /** Returns the pixel with this [number], 0 until [count]. */
    operator fun get(number: Int): Int = all[number]

    /** Adds a [color] to a pixel, for as many samples as [weight] says, see [CORNER]. */
    fun add(pixel: Int, color: Int, weight: Int) {
        if (weight and CORNER != 0) corners[pixel] = color
        LightSums.add(sums, CHANNELS * pixel, color, (weight and CORNER.inv()).toLong())
    }

    /**
     * Adds the colours [argb] from number [first] until [end] to a pixel; [weight] returns for how many samples each
     * is.
     */
    inline fun add(pixel: Int, argb: IntArray, first: Int, end: Int, weight: (i: Int) -> Int) {
        LightSums.add(sums, CHANNELS * pixel, argb, first, end) { i ->
            val samples = weight(i)
            if (samples and CORNER != 0) corners[pixel] = argb[i]
            samples and CORNER.inv()
        }
    }

    /** Returns the mean of a [pixel] with so many [samples]. */
    fun mean(pixel: Int, samples: Int): Int =
        LightSums.mean(sums, CHANNELS * pixel, samples.toLong(), corners[pixel])

    companion object {
        /** Bit of a weight: one of the samples is the upper left one of the pixel. */
        const val CORNER: Int = 1 shl 16
    }
}
