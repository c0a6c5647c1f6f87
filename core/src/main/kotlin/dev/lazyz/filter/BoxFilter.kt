package dev.lazyz.filter

import dev.lazyz.DepthTest
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.Srgb

/**
 * Receives rows of samples, and passes on rows of pixels, each the mean of [factor] x [factor] samples. See
 * [SuperSampling].
 *
 * Light is added as integers of [LIGHT_BITS] bits, times the 8-bit alpha: 64-bit sums are exact. Belongs to one
 * rendering.
 */
internal class BoxFilter(
    private val factor: Int,
    private val pixels: Region,
    private val test: DepthTest,
    private val sink: RowSink,
) : RowSink {
    private val width = pixels.width
    private val red = LongArray(width)
    private val green = LongArray(width)
    private val blue = LongArray(width)
    private val alpha = IntArray(width)
    private val keys = LongArray(width)

    // The row of pixels; until it is complete, each colour is that of the upper left sample
    private val argb = IntArray(width)
    private val depths = IntArray(width)
    private val indices = IntArray(width)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        if (y % factor == 0) begin(argb)
        for (x in 0 until width) add(x, argb, depth, primitive)
        if (y % factor == factor - 1) end(y / factor)
    }

    private fun begin(argb: IntArray) {
        red.fill(0)
        green.fill(0)
        blue.fill(0)
        alpha.fill(0)
        keys.fill(Long.MAX_VALUE)
        for (x in 0 until width) this.argb[x] = argb[x * factor]
    }

    /** Adds the samples of one row to pixel [x]. */
    private fun add(x: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        var r = 0L
        var g = 0L
        var b = 0L
        var a = 0
        var key = keys[x]
        for (i in x * factor until (x + 1) * factor) {
            val color = argb[i]
            val weight = color ushr 24
            r += weight.toLong() * LIGHT[color shr 16 and 0xFF]
            g += weight.toLong() * LIGHT[color shr 8 and 0xFF]
            b += weight.toLong() * LIGHT[color and 0xFF]
            a += weight
            key = minOf(key, test.key(depth[i], primitive[i]))
        }
        red[x] += r
        green[x] += g
        blue[x] += b
        alpha[x] += a
        keys[x] = key
    }

    private fun end(y: Int) {
        for (x in 0 until width) {
            if (alpha[x] > 0) argb[x] = mean(x)
            depths[x] = test.depthOf(keys[x])
            indices[x] = test.indexOf(keys[x])
        }
        sink.row(y, argb, depths, indices)
    }

    private fun mean(x: Int): Int {
        val samples = factor * factor
        val opacity = (2 * alpha[x] + samples) / (2 * samples)
        return opacity shl 24 or (code(red[x], alpha[x]) shl 16) or (code(green[x], alpha[x]) shl 8) or
            code(blue[x], alpha[x])
    }

    /** Returns the sRGB code of the light whose sum, weighted by alpha, is [sum]. */
    private fun code(sum: Long, alpha: Int): Int =
        Srgb.encode((sum.toDouble() / (alpha.toDouble() * (1 shl LIGHT_BITS))).toFloat())

    private companion object {
        const val LIGHT_BITS = 24

        /** The light of each sRGB code, 0..2^[LIGHT_BITS]. */
        val LIGHT = IntArray(256) { (Srgb.decode(it / 255.0) * (1 shl LIGHT_BITS) + 0.5).toInt() }
    }
}
