package dev.lazyz.conformance.strangers3

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import java.io.IOException
import java.io.UncheckedIOException
import java.util.concurrent.ConcurrentHashMap

/** Each row is a merge of sorted run lists, two by two, until one list is left. */
internal class SpanMerge(options: RenderOptions = RenderOptions(), mistake: Mistake? = null) :
    Third("spans", options, mistake) {
    private val sorted = ConcurrentHashMap<Any, LongArray>()
    private var last: Frame? = null

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): Renderer = SpanMerge(options.requireSupportedBy(this), mistake)

    override fun render(frame: Frame, sink: RowSink): Counters {
        refuseTranslucent(frame)
        if (mistake == Mistake.SPANS_KEEPS_FRAME) last = frame
        return Rendering(frame, sink).run()
    }

    private fun entries(frame: Frame): LongArray =
        if (mistake == Mistake.SPANS_CACHE_KEY) {
            sorted.getOrPut(frame.primitives.size to frame.region) { arrivals(frame) }
        } else {
            arrivals(frame)
        }

    private class Active(val index: Int, val primitive: Primitive, val cursor: SpanCursor)

    private inner class Rendering(private val frame: Frame, private val sink: RowSink) {
        private val region = frame.region
        private val test = frame.raster.depthTest
        private val counters = Counters.Builder()
        private val shading = RowShading(frame, options.coherence, counters, mistake)
        private val contest = Contest(frame, counters, mistake)
        private val entries = entries(frame)
        private var entered = 0
        private val active = ArrayList<Active>()
        private val spans = Spans(region)
        private val free = ArrayList<Runs>()
        private var runBytes = 0L
        private var mostActive = 0
        private val row = OutRow(frame)

        fun run(): Counters {
            counters.primitives = frame.primitives.size.toLong()
            row.clear()
            for (y in region.rowStart until region.rowEnd) {
                checkInterrupt()
                admit(y)
                val runs = merged(0, active.size, y)
                show(runs, y)
                send(y)
                if (mistake == Mistake.SPANS_SHARED_ROW) wipe(runs)
                give(runs)
                active.removeIf { it.primitive.rowEnd <= y + 1 }
            }
            counters.peakBytes =
                8L * entries.size + row.bytes + runBytes + 32L * mostActive + shading.bytes + 64
            return counters.build()
        }

        private fun checkInterrupt() {
            val stop =
                if (mistake == Mistake.SPANS_STATUS_LEFT) Thread.currentThread().isInterrupted else Thread.interrupted()
            if (stop) throw InterruptedException("interrupted")
        }

        private fun admit(y: Int) {
            while (entered < entries.size && (entries[entered] ushr 32).toInt() <= y) {
                val index = entries[entered++].toInt()
                val primitive = frame.primitives[index]
                val from = if (mistake == Mistake.SPANS_CURSOR_TOP) maxOf(primitive.rowStart, 0) else y
                active += Active(index, primitive, primitive.cursor(from))
            }
            mostActive = maxOf(mostActive, active.size)
        }

        /** Merges the runs of the primitives [from] until [until] of row [y]. */
        private fun merged(from: Int, until: Int, y: Int): Runs {
            val out = take()
            if (until - from <= 1) {
                if (from < until) leaf(active[from], out)
                return out
            }
            val middle = (from + until) ushr 1
            val left = merged(from, middle, y)
            val right = merged(middle, until, y)
            contest.merge(left, right, y, out)
            give(left)
            give(right)
            return out
        }

        private fun leaf(one: Active, out: Runs) {
            one.cursor.next(spans)
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                out.add(spans.start(i), spans.end(i), one.index)
            }
        }

        private fun take(): Runs = free.removeLastOrNull() ?: Runs(mistake)

        private fun give(runs: Runs) {
            runBytes = maxOf(runBytes, free.sumOf { it.bytes } + runs.bytes)
            runs.clear()
            free += runs
        }

        private fun show(runs: Runs, y: Int) {
            if (mistake != Mistake.SPANS_SHARED_ROW) row.clear()
            shading.beginRow()
            var visible = 0L
            val limit = frame.backgroundKey
            for (i in 0 until runs.count) {
                val index = runs.index(i)
                val primitive = frame.primitives[index]
                for (x in runs.start(i) until runs.end(i)) {
                    val depth = primitive.depthAt(x, y)
                    counters.depthEvaluations++
                    val key = test.key(depth, index)
                    val isTie = mistake == Mistake.SPANS_BACKGROUND_TIE && depth == frame.raster.backgroundDepth
                    if (key >= limit && !isTie) continue
                    counters.depthPasses++
                    visible++
                    row.depth[x - region.columnStart] = depth
                    row.primitive[x - region.columnStart] = index
                    row.argb[x - region.columnStart] = shading.shade(x, y, index).toArgb()
                }
            }
            counters.peakSuspensions = maxOf(counters.peakSuspensions, visible)
        }

        private fun send(y: Int) {
            try {
                row.send(y, sink)
            } catch (e: IOException) {
                throw if (mistake == Mistake.SPANS_SINK_WRAPPED) UncheckedIOException(e) else e
            }
        }

        /** Puts the background back where something was shown. */
        private fun wipe(runs: Runs) {
            val start = region.columnStart
            for (i in 0 until runs.count) {
                row.argb.fill(frame.raster.background.toArgb(), runs.start(i) - start, runs.end(i) - start)
                row.depth.fill(frame.raster.backgroundDepth, runs.start(i) - start, runs.end(i) - start)
                row.primitive.fill(-1, runs.start(i) - start, runs.end(i) - start)
            }
        }
    }
}
