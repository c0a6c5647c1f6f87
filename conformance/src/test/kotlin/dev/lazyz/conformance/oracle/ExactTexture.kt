package dev.lazyz.conformance.oracle

import dev.lazyz.world.material.Texture

/** Reads a texture as contract rule 6.6 defines without a mip filter, in double precision. */
internal class ExactTexture(private val texture: Texture) {
    /** Returns red, green, blue, linear, and alpha at ([u], [v]). */
    fun at(u: Double, v: Double): DoubleArray {
        val x = u * texture.width
        val y = v * texture.height
        if (texture.filter == Texture.Filter.NEAREST) return texel(Math.floor(x).toLong(), Math.floor(y).toLong())
        val left = Math.floor(x - 0.5)
        val top = Math.floor(y - 0.5)
        val sum = DoubleArray(4)
        for (corner in 0 until 4) {
            val column = left + corner % 2
            val row = top + corner / 2
            val weight = (1 - Math.abs(x - 0.5 - column)) * (1 - Math.abs(y - 0.5 - row))
            val texel = texel(column.toLong(), row.toLong())
            for (k in 0 until 4) sum[k] += weight * texel[k]
        }
        return sum
    }

    private fun texel(x: Long, y: Long): DoubleArray {
        val column = wrapped(x, texture.width, texture.wrapU)
        val row = wrapped(y, texture.height, texture.wrapV)
        val argb = texture.texel(column, row)
        return doubleArrayOf(
            decoded(argb ushr 16 and 0xFF), decoded(argb ushr 8 and 0xFF), decoded(argb and 0xFF),
            (argb ushr 24) / 255.0,
        )
    }

    private fun decoded(code: Int): Double =
        if (texture.encoding == Texture.Encoding.SRGB) linear(code) else code / 255.0

    private fun wrapped(index: Long, size: Int, wrap: Texture.Wrap): Int = when (wrap) {
        Texture.Wrap.REPEAT -> Math.floorMod(index, size)
        Texture.Wrap.MIRROR -> Math.floorMod(index, 2 * size).let { if (it < size) it else 2 * size - 1 - it }
        Texture.Wrap.CLAMP -> index.coerceIn(0L, size - 1L).toInt()
    }

    companion object {
        /** The sRGB curve (IEC 61966-2-1). */
        private fun linear(code: Int): Double {
            val encoded = code / 255.0
            return if (encoded <= 0.04045) encoded / 12.92 else Math.pow((encoded + 0.055) / 1.055, 2.4)
        }

        /** Its inverse: 0..255, not rounded. */
        fun encoded(linear: Double): Double {
            val clamped = if (linear > 0.0) minOf(linear, 1.0) else 0.0
            val encoded = if (clamped <= 0.0031308) clamped * 12.92 else 1.055 * Math.pow(clamped, 1 / 2.4) - 0.055
            return 255.0 * encoded
        }
    }
}
