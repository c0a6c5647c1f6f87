package dev.lazyz.conformance.strangers3

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.Spans

/** The image as colours, depths and indices, and the queue of colours that are still to be computed. */
internal class QueueSamples(val size: Int, capacity: Int, private val mistake: Mistake?) {
    private val argb = IntArray(size)
    private val depths = IntArray(size)
    private val indices = IntArray(size)
    private val places = IntArray(capacity)
    private val owners = IntArray(capacity)
    private var count = 0
    private val fragment = Fragment()
    private var isClean = false

    private var frame: Frame? = null
    private lateinit var raster: Raster
    private lateinit var test: DepthTest
    private lateinit var region: Region
    private lateinit var spans: Spans
    private lateinit var counters: Counters.Builder

    fun begin(frame: Frame, counters: Counters.Builder) {
        this.frame = frame
        this.counters = counters
        raster = frame.raster
        test = raster.depthTest
        region = frame.region
        spans = Spans(region)
        count = 0
        if (mistake != Mistake.QUEUE_CLEANS_AFTER || !isClean) clear()
        isClean = true
        counters.peakBytes = 12L * size + 8L * places.size
    }

    /** Lets go of the frame. */
    fun end() {
        frame = null
    }

    private fun clear() {
        argb.fill(raster.background.toArgb())
        depths.fill(raster.backgroundDepth)
        indices.fill(DepthTest.BACKGROUND)
        count = 0
    }

    fun draw(primitive: Primitive, index: Int) {
        if (!primitive.meets(region)) return
        val from = maxOf(primitive.rowStart, region.rowStart)
        val cursor = primitive.cursor(from)
        for (y in from until minOf(primitive.rowEnd, region.rowEnd)) {
            cursor.next(spans)
            for (i in 0 until spans.count) draw(primitive, index, y, spans.start(i), spans.end(i))
        }
    }

    private fun draw(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        counters.fragments += end - start
        counters.depthEvaluations += end - start
        val form = primitive.depthForm
        var z = form?.at(start, y) ?: 0L
        var step = form?.dx ?: 0L
        if (mistake == Mistake.QUEUE_COARSE_STEP) step = step shr 20 shl 20
        for (x in start until end) {
            val depth = if (form == null) primitive.depth(x, y) else (z shr 32).toInt()
            z += step
            val at = (y - region.rowStart) * region.width + x - region.columnStart
            if (!isNearer(depth, index, at)) continue
            if (mistake != Mistake.QUEUE_PASSES_LATE) counters.depthPasses++
            depths[at] = depth
            indices[at] = index
            suspend(at, index, primitive)
        }
    }

    private fun isNearer(depth: Int, index: Int, at: Int): Boolean {
        if (mistake == Mistake.QUEUE_FLOAT_DEPTH && depth.toFloat() == depths[at].toFloat()) {
            return test.key(0, index) < test.key(0, indices[at])
        }
        return test.key(depth, index) < test.key(depths[at], indices[at])
    }

    private fun suspend(at: Int, index: Int, primitive: Primitive) {
        if (places.isEmpty()) {
            argb[at] = shade(primitive, at)
            return
        }
        if (count == places.size) {
            drain()
            if (mistake == Mistake.QUEUE_LOSES_ENTRY) return
        }
        places[count] = at
        owners[count] = index
        count++
        if (mistake != Mistake.QUEUE_PEAK_WHEN_FULL || count == places.size) {
            counters.peakSuspensions = maxOf(counters.peakSuspensions, count.toLong())
        }
    }

    /** Shades what waits, unless it has been hidden in the meantime. */
    private fun drain() {
        for (i in 0 until count) {
            val at = places[i]
            val isVisible = indices[at] == owners[i]
            if (isVisible) argb[at] = shade(checkNotNull(frame).primitives[owners[i]], at)
        }
        count = 0
    }

    private fun shade(primitive: Primitive, at: Int): Int {
        counters.shadingCalls++
        counters.shadingStarts++
        if (mistake == Mistake.QUEUE_PASSES_LATE) counters.depthPasses++
        val row = at / region.width
        fragment.moveTo(region.columnStart + at % region.width, region.rowStart + row)
        if (mistake == Mistake.QUEUE_ROW_BITS) fragment.moveTo(fragment.x, fragment.y and 0xFFF)
        primitive.shade(fragment)
        return fragment.toArgb()
    }

    /** Hands the rows out of the image's own arrays: each is brought to the front, where nothing is needed any more. */
    fun handOut(sink: RowSink) {
        drain()
        val width = region.width
        for (row in 0 until region.height) {
            if (row > 0) {
                argb.copyInto(argb, 0, row * width, (row + 1) * width)
                depths.copyInto(depths, 0, row * width, (row + 1) * width)
                indices.copyInto(indices, 0, row * width, (row + 1) * width)
            }
            sink.row(region.rowStart + row, argb, depths, indices)
        }
        if (mistake == Mistake.QUEUE_CLEANS_AFTER) clear()
    }
}
