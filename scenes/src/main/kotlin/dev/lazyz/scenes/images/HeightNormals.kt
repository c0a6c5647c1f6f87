package dev.lazyz.scenes.images

import dev.lazyz.world.material.Texture
import kotlin.math.sqrt

/**
 * Converts a bump map, an image of heights, to a normal map.
 *
 * A height is the mean of red, green and blue, 0..1, times the factor, times [DEPTH] of the longer side of the image.
 * The slope at a texel is half the difference of its neighbours on both sides; beyond the border, the image continues
 * as the texture does.
 */
internal object HeightNormals {
    /** Depth of a full-range bump map, as a part of the longer side of the image. */
    private const val DEPTH = 1.0 / 128

    /** Returns the normals of the [heights] multiplied by [factor]: right, up and out as red, green and blue. */
    fun of(heights: Texture, factor: Double): Texture {
        val width = heights.width
        val height = heights.height
        val depth = factor * DEPTH * maxOf(width, height) / (3 * 255)
        val sums = IntArray(width * height) {
            val texel = heights.texel(it % width, it / width)
            (texel ushr 16 and 0xFF) + (texel ushr 8 and 0xFF) + (texel and 0xFF)
        }
        val normals = IntArray(width * height) {
            val x = it % width
            val row = it / width * width
            val left = sums[row + beside(x - 1, width, heights.wrapU)]
            val right = sums[row + beside(x + 1, width, heights.wrapU)]
            val above = sums[beside(it / width - 1, height, heights.wrapV) * width + x]
            val below = sums[beside(it / width + 1, height, heights.wrapV) * width + x]
            normal((left - right) * depth / 2, (below - above) * depth / 2)
        }
        return Texture(
            width, height, normals, heights.filter, heights.wrapU, heights.wrapV, heights.name, heights.mipFilter,
            Texture.Encoding.LINEAR,
        )
    }

    /** Returns the texel of the normal (x, y, 1), of unit length. */
    private fun normal(x: Double, y: Double): Int {
        val length = sqrt(x * x + y * y + 1.0)
        return 0xFF shl 24 or (code(x / length) shl 16) or (code(y / length) shl 8) or code(1.0 / length)
    }

    private fun code(component: Double): Int = ((component + 1.0) / 2 * 255 + 0.5).toInt()

    private fun beside(index: Int, size: Int, wrap: Texture.Wrap): Int = when {
        index in 0 until size -> index
        wrap == Texture.Wrap.REPEAT -> if (index < 0) size - 1 else 0
        else -> if (index < 0) 0 else size - 1
    }
}
