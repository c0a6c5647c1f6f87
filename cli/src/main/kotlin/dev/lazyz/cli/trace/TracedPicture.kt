package dev.lazyz.cli.trace

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RowSink
import java.util.BitSet

/** Keeps the final picture of [region], opaque: before white if its background is not. */
internal class TracedPicture(private val region: Region) : RowSink {
    val width: Int get() = region.width
    val height: Int get() = region.height

    /** The colours in rows from the top, `0xAARRGGBB`. */
    val argb = IntArray(Math.toIntExact(region.size))

    /** The pixels at which a surface is visible. */
    val covered = BitSet(argb.size)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val first = (y - region.rowStart) * width
        for (x in 0 until width) {
            this.argb[first + x] = beforeWhite(argb[x])
            if (primitive[x] != DepthTest.BACKGROUND) covered.set(first + x)
        }
    }

    /** Returns the picture, without copying its colours. It has no depth. */
    fun toImage(): Image = Image(
        width, height, argb, IntArray(argb.size), IntArray(argb.size) { DepthTest.BACKGROUND }, Counters.NONE,
    )

    private fun beforeWhite(color: Int): Int {
        val alpha = color ushr 24
        fun channel(shift: Int) = ((color shr shift and 0xFF) * alpha + 255 * (255 - alpha) + 127) / 255 shl shift
        return 0xFF shl 24 or channel(16) or channel(8) or channel(0)
    }
}
