package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.spi.Spans

/** The plain depth buffer: a key and a colour for every sample; shades what is nearer at once. */
internal open class PlainDrawing(frame: Frame) : Drawing(frame) {
    val keys = LongArray(region.size.toInt())
    val colors = IntArray(region.size.toInt())
    val spans = region.spans()

    override fun run(sink: RowSink): Counters {
        keys.fill(backgroundKey())
        colors.fill(backgroundArgb())
        counters.peakBytes = 12L * keys.size
        drawAll()
        for (y in region.rowStart until region.rowEnd) finishRow(keys, (y - region.rowStart) * width, y, sink)
        return counters.build()
    }

    open fun drawAll() {
        for ((index, primitive) in primitives.withIndex()) {
            counters.primitives++
            draw(primitive, index)
        }
    }

    open fun draw(primitive: Primitive, index: Int) {
        if (!reaches(primitive)) return
        val top = maxOf(primitive.rowStart, region.rowStart)
        val cursor = primitive.cursor(top)
        for (y in top until minOf(primitive.rowEnd, region.rowEnd)) {
            cursor.next(spans)
            for (i in 0 until spans.count) drawSpan(primitive, index, y, spans.start(i), spans.end(i))
        }
    }

    open fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        count(start, end)
        walk(primitive, y, start, end)
        var at = (y - region.rowStart) * width + start - region.columnStart
        for (x in start until end) {
            val key = key(spanDepths[x - start], index)
            if (passes(key, keys[at])) {
                keys[at] = key
                counters.depthPasses++
                show(at, index, x, y)
            }
            at++
        }
    }

    open fun passes(key: Long, best: Long): Boolean = key < best

    /** The sample at [at] shows the primitive [index] from now on. */
    open fun show(at: Int, index: Int, x: Int, y: Int) {
        colors[at] = color(index, x, y)
    }

    override fun color(index: Int, x: Int, y: Int): Int {
        counters.shadingCalls++
        fragment.moveTo(x, y)
        primitives[index].shade(fragment)
        return fragment.toArgb()
    }

    override fun colorRow(y: Int) {
        val at = (y - region.rowStart) * width
        colors.copyInto(argb, 0, at, at + width)
    }
}

internal fun plain(drawing: (Frame) -> PlainDrawing): Renderer =
    Workbench("plain", { setOf(Capability.STREAMS_PRIMITIVES) }) { frame, _ -> drawing(frame) }
