package dev.lazyz.filter

import dev.lazyz.Region
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
