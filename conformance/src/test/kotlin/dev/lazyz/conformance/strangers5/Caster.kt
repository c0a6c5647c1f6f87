package dev.lazyz.conformance.strangers5

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Selector

/**
 * Casts a ray through every sample of a row, into a segment tree over the row's columns: a span hangs at the few nodes
 * that make it up, and a ray meets the nodes from its leaf to the root. Lists at nodes run from near to far, by the
 * bounds of primitives, so that a ray that only wants the nearest fragment leaves them early.
 */
internal class Caster(private val options: RenderOptions = RenderOptions(), private val mistake: Mistake? = null) :
    Renderer {
    override val id: String get() = "caster5"
    override val summary: String get() = "rays through a segment tree of each row's spans"

    override val capabilities: Set<Capability>
        get() {
            val isUsual = options.selector == null || options.selector === Selector.nearest()
            return if (isUsual) ALWAYS + Capability.SHADES_ONLY_VISIBLE else ALWAYS
        }

    override fun configured(options: RenderOptions): Renderer = Caster(options.requireSupportedBy(this), mistake)

    override fun render(frame: Frame, sink: RowSink): Counters {
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val active = CasterActive(frame, mistake)
        val spans = CasterSpans(frame, counters, mistake)
        val colors = Chains(frame, options.coherence, counters, mistake)
        val cell = CasterCell(frame, spans, colors, counters, mistake)
        val selector = options.selector
        val isNearest = selector === Selector.nearest() || (selector == null && !frame.hasTranslucency)
        val width = frame.width
        val first = frame.region.columnStart
        val argb = IntArray(width)
        val depths = IntArray(width)
        val indices = IntArray(width)
        val test = frame.raster.depthTest
        val background = frame.raster.background.toArgb()
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            active.moveTo(y)
            spans.fill(y, active)
            colors.beginRow()
            for (i in 0 until width) {
                if (isNearest) {
                    val key = spans.nearest(i)
                    depths[i] = test.depthOf(key)
                    val index = test.indexOf(key)
                    indices[i] = index
                    argb[i] =
                        if (index == DepthTest.BACKGROUND) background else colors.shade(first + i, y, index).toArgb()
                    continue
                }
                cell.moveTo(i, y)
                argb[i] = background
                depths[i] = frame.raster.backgroundDepth
                indices[i] = DepthTest.BACKGROUND
                if (cell.size == 0) continue
                if (selector == null) cell.blend() else selector.select(cell)
                if (!cell.isShown) continue
                argb[i] = cell.color()
                depths[i] = cell.depth(cell.shown)
                indices[i] = cell.primitive(cell.shown)
            }
            sink.row(y, argb, depths, indices)
        }
        counters.peakBytes = 12L * width + active.bytes + spans.bytes + cell.bytes + colors.peakBytes
        return counters.build()
    }

    private companion object {
        val ALWAYS: Set<Capability> = setOf(
            Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.TRANSPARENCY, Capability.COHERENCE,
            Capability.SELECTION,
        )
    }
}
