package dev.lazyz.filter

import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.spi.Srgb

/**
 * What is behind the pixels of a picture, in place of one colour. The frame has a transparent background. Each row of
 * pixels is composited over this in linear light, so all renderers, options and regions work, and pixels of a region
 * are those of the whole picture. Depths and primitives are passed on unchanged. Immutable and thread safe.
 */
public interface PixelBackground {
    /**
     * Returns a sink for rows of [region], a part of a picture with [height] rows. It passes opaque rows to [sink]. Not
     * thread safe.
     *
     * @throws IllegalArgumentException if the region reaches below the picture
     */
    public fun behind(region: Region, height: Int, sink: RowSink): RowSink

    /**
     * A background that changes evenly from the top of a picture to its bottom.
     *
     * ```
     * val sky = VerticalGradient(Rgba.ofRgb(0x7FB2E5), Rgba.WHITE)
     * val frame = scene.frame(Raster(640, 480, Rgba.TRANSPARENT))
     * renderer.render(frame, sky.behind(frame.region, 480, sink))
     * ```
     *
     * With [SuperSampling], the gradient is behind the pixels, not the samples.
     *
     * The gradient is linear in the codes of sRGB, as in CSS ("CSS Images Level 3", section 3.4), which looks even. Its
     * colour in row y, counted from 0, is that at (y + 1/2) / height of the way. Translucent pixels have 8 bits a
     * component before they are composited.
     *
     * Immutable and thread safe. Cost: a product for each translucent pixel; no memory.
     *
     * @property top the colour at the upper edge
     * @property bottom the colour at the lower edge
     * @throws IllegalArgumentException if a colour is not opaque
     */
    public class VerticalGradient(public val top: Rgba, public val bottom: Rgba) : PixelBackground {
        init {
            require(top.alpha >= 1f && bottom.alpha >= 1f) { "colours of a gradient must be opaque: $top, $bottom" }
        }

        private val first = top.toArgb()
        private val last = bottom.toArgb()

        override fun behind(region: Region, height: Int, sink: RowSink): RowSink {
            require(region.rowEnd <= height) { "$region must be within $height rows" }
            return RowSink { y, argb, depth, primitive ->
                val way = (y + 0.5) / height
                val light = DoubleArray(3) { component(16 - 8 * it, way) }
                for (x in 0 until region.width) argb[x] = composited(argb[x], light)
                sink.row(y, argb, depth, primitive)
            }
        }

        /** Returns red, green or blue of one row: the 8 bits from [shift] on. */
        private fun component(shift: Int, way: Double): Double {
            val from = first ushr shift and 0xFF
            val to = last ushr shift and 0xFF
            return Srgb.decode((from + (to - from) * way) / 255.0)
        }

        override fun toString(): String = "VerticalGradient($top, $bottom)"
    }
}

/** Returns the pixel [argb] in front of red, green and blue [light], opaque. */
internal fun composited(argb: Int, light: DoubleArray): Int {
    val alpha = argb ushr 24
    if (alpha == 0xFF) return argb
    var pixel = 0xFF
    for (channel in 0 until 3) {
        val front = Srgb.decode(argb ushr 16 - 8 * channel and 0xFF)
        val sum = (alpha * front + (255 - alpha) * light[channel]) / 255.0
        pixel = pixel shl 8 or Srgb.encode(sum.toFloat())
    }
    return pixel
}
