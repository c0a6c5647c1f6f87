package example

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min
import kotlin.math.sqrt

/** A disc on the screen, at one [depth] in 0..2^31-1. The centre and the radius are in pixels. */
class Disc(
    private val raster: Raster,
    private val centerX: Int,
    private val centerY: Int,
    private val radius: Int,
    private val depth: Int,
) : Primitive {
    override val rowStart: Int get() = max(centerY - radius, 0)

    override val rowEnd: Int get() = min(centerY + radius + 1, raster.height)

    override val columnStart: Int get() = max(centerX - radius, 0)

    override val columnEnd: Int get() = min(centerX + radius + 1, raster.width)

    override fun spans(y: Int, spans: Spans) {
        val rest = radius * radius - (y - centerY) * (y - centerY)
        if (rest < 0) return
        val half = sqrt(rest.toDouble()).toInt()
        val start = max(centerX - half, 0)
        val end = min(centerX + half + 1, raster.width)
        if (start < end) spans.add(start, end)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun shade(fragment: Fragment) {
        fragment.setColor(1f - 0.5f * abs(fragment.x - centerX) / radius, 0.4f, 0.1f)
    }
}
