package dev.lazyz.conformance.strangers4

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Spans
import java.io.IOException
import java.io.UncheckedIOException

/** An A-buffer: in a band of rows each sample keeps a list of its fragments, to be sorted, then chosen or blended. */
internal class ListStranger(
    private val mistake: Mistake? = null,
    private val options: RenderOptions = RenderOptions(),
) : Renderer {
    override val id: String get() = "stranger-list"
    override val summary: String get() = "bands of rows, a list of fragments a sample, sorted, then chosen or blended"
    override val capabilities: Set<Capability>
        get() {
            val always = setOf(Capability.TRANSPARENCY, Capability.SELECTION, Capability.CONSTANT_MEMORY)
            return if (options.selector == null) always + Capability.SHADES_ONLY_VISIBLE else always
        }

    override fun configured(options: RenderOptions): Renderer {
        options.requireSupportedBy(this)
        if (mistake != Mistake.LIST_SELECTOR_KEPT || options.selector != null) return ListStranger(mistake, options)
        val merged = RenderOptions(
            options.coherence, options.memoryBudget, options.threads, options.tileSize, this.options.selector,
        )
        return ListStranger(mistake, merged)
    }

    override fun render(frame: Frame, sink: RowSink): Counters {
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val touching = frame.primitives.indices.filter { frame.primitives[it].touches(frame.region) }.toIntArray()
        val bandRows = (BAND_SAMPLES / frame.width).coerceIn(1, MOST_ROWS)
        val band = ListBand(frame, minOf(bandRows, frame.height), counters, mistake)
        val choice = ListChoice(frame, band, options.selector, counters, mistake)
        var top = frame.region.rowStart
        while (top < frame.region.rowEnd) {
            val bottom = minOf(top + bandRows, frame.region.rowEnd)
            band.begin(top)
            val area = Region(frame.region.columnStart, top, frame.region.columnEnd, bottom)
            for (index in touching) {
                if (frame.primitives[index].touches(area)) band.draw(frame.primitives[index], index, area)
            }
            for (y in top until bottom) {
                choice.choose(y)
                handOut(y, choice, sink)
            }
            counters.peakBytes = maxOf(counters.peakBytes, 4L * touching.size + band.bytes + choice.bytes)
            top = bottom
        }
        return counters.build()
    }

    private fun handOut(y: Int, choice: ListChoice, sink: RowSink) {
        if (mistake != Mistake.LIST_IO_WRAPPED) {
            sink.row(y, choice.argb, choice.depths, choice.indices)
            return
        }
        try {
            sink.row(y, choice.argb, choice.depths, choice.indices)
        } catch (e: IOException) {
            throw UncheckedIOException(e)
        }
    }

    override fun toString(): String = "ListStranger($mistake, $options)"

    private companion object {
        const val BAND_SAMPLES = 1 shl 16
        const val MOST_ROWS = 16
    }
}

/** The fragments of some rows, as one list a sample, the last drawn first. */
internal class ListBand(
    private val frame: Frame,
    rows: Int,
    private val counters: Counters.Builder,
    private val mistake: Mistake?,
) {
    private val test = frame.raster.depthTest
    private val background = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val spans = Spans(frame.region)
    private val heads = IntArray(rows * frame.width)
    private var depths = IntArray(256)
    private var indices = IntArray(256)
    private var nexts = IntArray(256)
    private var count = 0
    private var top = 0

    val bytes: Long get() = 4L * heads.size + 12L * depths.size

    fun begin(top: Int) {
        this.top = top
        heads.fill(NONE)
        if (mistake != Mistake.LIST_POOL_LEAKS) count = 0
    }

    fun draw(primitive: Primitive, index: Int, area: Region) {
        val from = maxOf(primitive.rowStart, area.rowStart)
        val cursor = primitive.cursor(from)
        val form = primitive.depthForm
        for (y in from until minOf(primitive.rowEnd, area.rowEnd)) {
            cursor.next(spans)
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                counters.depthEvaluations += spans.end(i) - spans.start(i)
                var z = form?.at(spans.start(i), y) ?: 0L
                for (x in spans.start(i) until spans.end(i)) {
                    add(x, y, if (form != null) (z shr 32).toInt() else primitive.depth(x, y), index)
                    if (form != null) z += step(form)
                }
            }
        }
        counters.peakSuspensions = maxOf(counters.peakSuspensions, count.toLong())
    }

    private fun step(form: LinearForm): Long =
        if (mistake == Mistake.LIST_WHOLE_STEPS) form.dx shr 32 shl 32 else form.dx

    /** Writes the keys of a sample's fragments into [keys], as they were drawn; returns it, or a longer array. */
    fun gather(x: Int, y: Int, keys: LongArray): LongArray {
        var array = keys
        size = 0
        var node = heads[at(x, y)]
        while (node != NONE) {
            if (size == array.size) array = array.copyOf(2 * size)
            array[size++] = test.key(depths[node], index(node))
            node = nexts[node]
            if (mistake == Mistake.LIST_LAYERS_CAPPED && size == MOST_LAYERS) break
        }
        array.reverse(0, size)
        return array
    }

    /** Number of fragments that were gathered. */
    var size: Int = 0
        private set

    private fun index(node: Int): Int =
        if (mistake == Mistake.LIST_SHORT_INDEX) indices[node] and 0xFFFF else indices[node]

    private fun add(x: Int, y: Int, depth: Int, index: Int) {
        if (isBehindBackground(depth, index)) return
        if (count == depths.size) {
            depths = depths.copyOf(2 * count)
            indices = indices.copyOf(2 * count)
            nexts = nexts.copyOf(2 * count)
        }
        depths[count] = depth
        indices[count] = index
        nexts[count] = heads[at(x, y)]
        heads[at(x, y)] = count++
    }

    private fun isBehindBackground(depth: Int, index: Int): Boolean = when (mistake) {
        Mistake.LIST_BACKGROUND_TIE -> test.key(depth, 0) ushr 32 >= background ushr 32
        Mistake.LIST_BACKGROUND_LATE -> false
        else -> test.key(depth, index) > background
    }

    private fun at(x: Int, y: Int): Int = (y - top) * frame.width + x - frame.region.columnStart

    private companion object {
        const val NONE = -1
        const val MOST_LAYERS = 16
    }
}
