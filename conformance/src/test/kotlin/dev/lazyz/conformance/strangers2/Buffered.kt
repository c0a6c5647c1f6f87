package dev.lazyz.conformance.strangers2

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Spans

/** A buffer of keys and colours, one primitive after the other, shaded at once. */
internal class Buffered(private val steps: BufferSteps) : Renderer {
    override val id: String get() = "buffered"
    override val summary: String get() = "a base of the second gallery"
    override val capabilities: Set<Capability> get() = setOf(Capability.STREAMS_PRIMITIVES)

    override fun render(frame: Frame, sink: RowSink): Counters {
        refuseTranslucent(frame, id)
        val pass = steps.pass(frame)
        val counters = pass.counters
        counters.primitives = steps.primitives(frame)
        counters.peakBytes = 12L * pass.keys.size
        steps.drawAll(pass)
        steps.handOut(pass, sink)
        steps.end(pass)
        return counters.build()
    }
}

/** One rendering of [Buffered]. */
internal class BufferPass(val frame: Frame, val keys: LongArray, val argb: IntArray) {
    val region = frame.region
    val width = frame.width
    val test = frame.raster.depthTest
    val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    val counters = Counters.Builder()
    val spans = Spans(region)
    var notes: List<IntArray> = emptyList()
    val fragment = Fragment()

    fun at(x: Int, y: Int): Int = (y - region.rowStart) * width + x - region.columnStart

    fun clear() {
        keys.fill(backgroundKey)
        argb.fill(frame.raster.background.toArgb())
    }
}

/** What [Buffered] does, step by step; mistakes replace single steps. */
internal open class BufferSteps {
    open fun pass(frame: Frame): BufferPass {
        val size = frame.width * frame.height
        return BufferPass(frame, LongArray(size), IntArray(size)).also { it.clear() }
    }

    open fun primitives(frame: Frame): Long = frame.primitives.size.toLong()

    open fun drawAll(pass: BufferPass) {
        for ((index, primitive) in pass.frame.primitives.withIndex()) draw(pass, index, primitive)
    }

    open fun draw(pass: BufferPass, index: Int, primitive: Primitive) {
        val region = pass.region
        val rows = region.rowStart until region.rowEnd
        if (!overlaps(primitive, region.columnStart until region.columnEnd, rows)) return
        val first = maxOf(primitive.rowStart, region.rowStart)
        val cursor = primitive.cursor(first)
        for (y in first until minOf(primitive.rowEnd, region.rowEnd)) {
            cursor.next(pass.spans)
            for (i in 0 until spanCount(pass, primitive)) {
                span(pass, index, primitive, y, pass.spans.start(i), pass.spans.end(i))
            }
        }
    }

    open fun spanCount(pass: BufferPass, primitive: Primitive): Int = pass.spans.count

    open fun span(pass: BufferPass, index: Int, primitive: Primitive, y: Int, start: Int, end: Int) {
        pass.counters.fragments += end - start
        countDepths(pass, primitive, end - start)
        val form = primitive.depthForm
        var z = form?.at(start, y) ?: 0L
        for (x in start until end) {
            sample(pass, index, primitive, x, y, if (form != null) (z shr 32).toInt() else primitive.depth(x, y))
            z += form?.dx ?: 0L
        }
    }

    open fun countDepths(pass: BufferPass, primitive: Primitive, count: Int) {
        pass.counters.depthEvaluations += count
    }

    open fun sample(pass: BufferPass, index: Int, primitive: Primitive, x: Int, y: Int, depth: Int) {
        val at = pass.at(x, y)
        val key = pass.test.key(depth, index)
        if (isVisible(pass, key, pass.keys[at])) show(pass, key, primitive, x, y)
    }

    open fun isVisible(pass: BufferPass, key: Long, old: Long): Boolean = key < old

    fun show(pass: BufferPass, key: Long, primitive: Primitive, x: Int, y: Int) {
        val at = pass.at(x, y)
        pass.keys[at] = key
        pass.counters.depthPasses++
        pass.counters.shadingCalls++
        pass.fragment.moveTo(x, y)
        primitive.shade(pass.fragment)
        pass.argb[at] = pass.fragment.toArgb()
    }

    open fun handOut(pass: BufferPass, sink: RowSink) {
        val width = pass.width
        val argb = IntArray(width)
        val depths = IntArray(width)
        val indices = IntArray(width)
        for (row in 0 until pass.region.height) {
            pass.argb.copyInto(argb, 0, row * width, (row + 1) * width)
            for (x in 0 until width) {
                depths[x] = depthOf(pass, pass.keys[row * width + x])
                indices[x] = pass.test.indexOf(pass.keys[row * width + x])
            }
            sink.row(pass.region.rowStart + row, argb, depths, indices)
        }
    }

    open fun depthOf(pass: BufferPass, key: Long): Int = pass.test.depthOf(key)

    open fun end(pass: BufferPass) = Unit
}
