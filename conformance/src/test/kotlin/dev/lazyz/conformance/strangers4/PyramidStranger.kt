package dev.lazyz.conformance.strangers4

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Spans
import java.util.concurrent.atomic.AtomicReference

/**
 * A depth buffer below a pyramid of bounds, as fine as the memory budget allows; primitives come one by one and are
 * shaded at the end. The rows are handed out in the image's arrays.
 */
internal class PyramidStranger(
    private val mistake: Mistake? = null,
    private val options: RenderOptions = RenderOptions(),
) : Renderer {
    private val spare = AtomicReference<PyramidImage>()
    private var keptSpans = Spans()

    override val id: String get() = "stranger-pyramid"
    override val summary: String get() = "a depth buffer below a pyramid of bounds within a memory budget"
    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.STREAMS_PRIMITIVES, Capability.MEMORY_BUDGET)

    override fun configured(options: RenderOptions): Renderer =
        PyramidStranger(mistake, options.requireSupportedBy(this))

    override fun render(frame: Frame, sink: RowSink): Counters {
        refuse(frame)
        val counters = Counters.Builder()
        val image = image(frame)
        val levels = levels(frame)
        counters.primitives = frame.primitives.size.toLong()
        counters.peakBytes = image.bytes
        if (levels != null) {
            counters.peakBytes += PyramidLevels.bytes(frame.width, frame.height, levels.side, null)
        }
        val drawer = PyramidDrawer(frame, image, levels, counters, spans(frame), mistake)
        if (mistake == Mistake.PYRAMID_SORTS_FIRST) {
            drawSorted(frame, drawer, counters)
        } else {
            var index = 0
            for (primitive in frame.primitives) {
                drawer.draw(primitive, index)
                if (mistake != Mistake.PYRAMID_NUMBERS_DRAWN || primitive.touches(frame.region)) index++
            }
        }
        drawer.finish(sink)
        if (mistake == Mistake.PYRAMID_DIRTY_ON_FAILURE) {
            image.clear(frame)
            spare.set(image)
        }
        return counters.build()
    }

    private fun refuse(frame: Frame) {
        if (mistake != Mistake.PYRAMID_REFUSES_IN_REGION) {
            refuseTranslucent(frame)
            return
        }
        if (frame.primitives.any { it.isTranslucent && it.touches(frame.region) }) refuseTranslucent(frame)
    }

    private fun spans(frame: Frame): Spans {
        if (mistake != Mistake.PYRAMID_SHARED_SPANS) return Spans(frame.region)
        val fits = keptSpans.columnStart == frame.region.columnStart && keptSpans.columnEnd == frame.region.columnEnd
        if (!fits) keptSpans = Spans(frame.region)
        return keptSpans
    }

    private fun image(frame: Frame): PyramidImage {
        require(frame.region.size <= Int.MAX_VALUE - 8L) { "too many samples to hold at once: ${frame.region.size}" }
        val size = frame.region.size.toInt()
        if (mistake == Mistake.PYRAMID_DIRTY_ON_FAILURE) {
            // The last image is clean again, if it fits
            val last = spare.get()
            if (last != null && last.argb.size == size && last.background == frame.raster.backgroundDepth) return last
        }
        val image = PyramidImage(size)
        image.clear(frame)
        if (mistake == Mistake.PYRAMID_DIRTY_ON_FAILURE) spare.set(image)
        return image
    }

    /** Returns the finest pyramid that the budget has room for, or null. */
    private fun levels(frame: Frame): PyramidLevels? {
        val budget = options.memoryBudget ?: Long.MAX_VALUE
        var side = LEAST_SIDE
        while (side <= MOST_SIDE) {
            if (PyramidLevels.bytes(frame.width, frame.height, side, mistake) <= budget) {
                return PyramidLevels(frame, side, mistake)
            }
            side *= 2
        }
        if (mistake == Mistake.PYRAMID_WARNS) System.err.println("$id: no room for a pyramid in $budget bytes")
        return null
    }

    private fun drawSorted(frame: Frame, drawer: PyramidDrawer, counters: Counters.Builder) {
        val test = frame.raster.depthTest
        val order = LongArray(frame.primitives.size) { test.boundOf(frame.primitives[it], it) }
        counters.peakBytes += 8L * order.size
        order.sort()
        for (key in order) drawer.draw(frame.primitives[test.indexOf(key)], test.indexOf(key))
    }

    override fun toString(): String = "PyramidStranger($mistake, $options)"

    private companion object {
        const val LEAST_SIDE = 8
        const val MOST_SIDE = 128
    }
}

/** 12 bytes a sample: what is to be handed out. */
internal class PyramidImage(size: Int) {
    val argb: IntArray = IntArray(size)
    val depths: IntArray = IntArray(size)
    val indices: IntArray = IntArray(size)
    var background: Int = 0
        private set

    val bytes: Long get() = 12L * argb.size

    fun clear(frame: Frame) {
        background = frame.raster.backgroundDepth
        depths.fill(background)
        indices.fill(DepthTest.BACKGROUND)
    }

    /** Returns arrays for one row alone. */
    fun ofRow(width: Int, counters: Counters.Builder): PyramidImage {
        counters.peakBytes += 12L * width
        return PyramidImage(width)
    }
}
