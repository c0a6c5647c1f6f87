package dev.lazyz.conformance.strangers5

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import java.io.IOException
import java.io.UncheckedIOException

/**
 * A span buffer: each row is a list of segments that do not overlap, at first one of background; spans are inserted one
 * after the other and take what they hide. Colours are computed for what is left. Does not blend.
 */
internal class SpanBuffer(private val mistake: Mistake? = null) : Renderer {
    private var shared: Array<IntArray>? = null

    override val id: String get() = "spanbuffer5"
    override val summary: String get() = "inserts spans into a list of visible segments, row by row"

    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS)

    override fun render(frame: Frame, sink: RowSink): Counters {
        refuse(frame)
        val rendering = SpanBufferRendering(frame, rows(frame.width), mistake)
        if (mistake == Mistake.SPANS_THREAD_LOCAL) last.set(rendering)
        try {
            for (y in frame.region.rowStart until frame.region.rowEnd) rendering.row(y, sink)
        } catch (e: IOException) {
            throw if (mistake == Mistake.SPANS_UNCHECKED) UncheckedIOException(e) else e
        }
        return rendering.finish()
    }

    private fun rows(width: Int): Array<IntArray> {
        if (mistake != Mistake.SPANS_SHARED_ROWS) return Array(3) { IntArray(width) }
        return shared?.takeIf { it[0].size >= width } ?: Array(3) { IntArray(width) }.also { shared = it }
    }

    private fun refuse(frame: Frame) {
        if (!frame.hasTranslucency) return
        val index = frame.primitives.indexOfFirst {
            it.isTranslucent && (mistake != Mistake.SPANS_REFUSES_SEEN || it.meets(frame.region))
        }
        require(index < 0) {
            "primitive $index is translucent, and '$id' does not blend: take a renderer that does, such as 'lists', " +
                "or make the frame opaque with asOpaque()"
        }
    }

    private companion object {
        val last = ThreadLocal<SpanBufferRendering>()
    }
}

/** One rendering's state. */
internal class SpanBufferRendering(
    private val frame: Frame,
    private val output: Array<IntArray>,
    private val mistake: Mistake?,
) {
    private val region = frame.region
    private val primitives = frame.primitives
    private val raster = frame.raster
    private val counters = Counters.Builder()
    private val segments = Segments(frame, counters, mistake)
    private val spans = Spans(region)
    private val fragment = Fragment()
    private val background = raster.background.toArgb()
    private val waiting: LongArray
    private var begun = 0
    private var active = IntArray(8)
    private var cursors = arrayOfNulls<SpanCursor>(8)
    private var count = 0

    /** Primitives and ends of the spans of this row and of the one above. */
    private var current = ArrayList<Int>()
    private var above = ArrayList<Int>()

    init {
        counters.primitives = primitives.size.toLong()
        var starts = LongArray(8)
        var size = 0
        for ((index, primitive) in primitives.withIndex()) {
            if (!primitive.meets(region)) continue
            if (size == starts.size) starts = starts.copyOf(2 * size)
            starts[size++] = maxOf(primitive.rowStart, region.rowStart).toLong() shl 32 or index.toLong()
        }
        waiting = starts.copyOf(size)
        waiting.sort()
    }

    /** Renders row [y], the next one. */
    fun row(y: Int, sink: RowSink) {
        activate(y)
        current.clear()
        for (i in 0 until count) {
            checkNotNull(cursors[i]).next(spans)
            for (k in 0 until spans.count) {
                current.add(active[i])
                current.add(spans.start(k))
                current.add(spans.end(k))
            }
        }
        val isSame = mistake == Mistake.SPANS_SAME_SPANS && y > region.rowStart && current == above
        if (!isSame) segments.begin()
        segments.y = y
        for (i in 0 until current.size step 3) {
            counters.fragments += current[i + 2] - current[i + 1]
            if (!isSame) segments.insert(current[i], current[i + 1], current[i + 2])
        }
        current = above.also { above = current }
        if (mistake == Mistake.SPANS_LOOKS_AHEAD) lookAhead(y + 1)
        segments.forEach { start, end, owner -> color(y, start, end, owner) }
        sink.row(y, output[0], output[1], output[2])
    }

    private fun activate(y: Int) {
        var kept = 0
        for (i in 0 until count) {
            if (primitives[active[i]].rowEnd <= y) continue
            active[kept] = active[i]
            cursors[kept++] = cursors[i]
        }
        cursors.fill(null, kept, count)
        count = kept
        while (begun < waiting.size && (waiting[begun] ushr 32).toInt() <= y) {
            if (count == active.size) {
                active = active.copyOf(2 * count)
                cursors = cursors.copyOf(2 * count)
            }
            active[count] = waiting[begun++].toInt()
            cursors[count] = primitives[active[count]].cursor(y)
            count++
        }
    }

    private fun lookAhead(y: Int) {
        for (i in 0 until count) {
            val primitive = primitives[active[i]]
            spans.clear()
            if (y < minOf(primitive.rowEnd, region.rowEnd)) primitive.spans(y, spans)
        }
    }

    private fun color(y: Int, start: Int, end: Int, owner: Int) {
        val first = region.columnStart
        if (owner == DepthTest.BACKGROUND) {
            output[0].fill(background, start - first, end - first)
            output[1].fill(raster.backgroundDepth, start - first, end - first)
            output[2].fill(DepthTest.BACKGROUND, start - first, end - first)
            return
        }
        val primitive = primitives[owner]
        val form = primitive.depthForm
        val isPlain = mistake == Mistake.SPANS_NO_CURSOR && primitive.shadingCursor(start, y) == null
        for (x in start until end) {
            if (x == start || !isPlain) {
                counters.shadingCalls++
                counters.shadingStarts++
                fragment.moveTo(x, y)
                primitive.shade(fragment)
            }
            output[0][x - first] = fragment.toArgb()
            output[1][x - first] = if (form != null) (form.at(x, y) shr 32).toInt() else primitive.depth(x, y)
            output[2][x - first] = owner
        }
        counters.depthEvaluations += end - start
        counters.peakSuspensions = maxOf(counters.peakSuspensions, (end - start).toLong())
    }

    /** Returns what it took. */
    fun finish(): Counters {
        counters.peakBytes = 8L * waiting.size + 12L * active.size + 12L * region.width + segments.bytes
        return counters.build()
    }
}
