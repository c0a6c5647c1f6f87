package dev.lazyz.strategies.tiled

import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.util.Collections

/** A rectangle of constant depth, without a form, that records the rows whose spans are requested. */
internal class Probe(private val region: Region, private val onShade: (x: Int, y: Int) -> Unit = { _, _ -> }) :
    Primitive {
    /** Rows whose spans were requested. */
    val rows: MutableList<Int> = Collections.synchronizedList(ArrayList<Int>())

    override val rowStart: Int get() = region.rowStart
    override val rowEnd: Int get() = region.rowEnd
    override val columnStart: Int get() = region.columnStart
    override val columnEnd: Int get() = region.columnEnd

    override fun spans(y: Int, spans: Spans) {
        rows += y
        spans.add(region.columnStart, region.columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = 1 shl 30

    override fun shade(fragment: Fragment) {
        onShade(fragment.x, fragment.y)
        fragment.setColor(fragment.x / 100f, fragment.y / 100f, 0f)
    }
}
