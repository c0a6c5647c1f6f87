package dev.lazyz.conformance.strangers3

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import java.io.File
import java.util.PriorityQueue

/** Sweeps down by events in a heap, and along each row from one span's end to the next; all fragments of a sample. */
internal class EventSweep(options: RenderOptions = RenderOptions(), mistake: Mistake? = null) :
    Third("events", options, mistake) {
    override val capabilities: Set<Capability>
        get() {
            val always = setOf(
                Capability.SELECTION, Capability.TRANSPARENCY, Capability.STREAMS_ROWS, Capability.CONSTANT_MEMORY,
                Capability.COHERENCE,
            )
            val isUsual = options.selector == null || options.selector === Selector.nearest()
            return if (isUsual) always + Capability.SHADES_ONLY_VISIBLE else always
        }

    override fun configured(options: RenderOptions): Renderer = EventSweep(options.requireSupportedBy(this), mistake)

    override fun render(frame: Frame, sink: RowSink): Counters = Rendering(frame, sink).run()

    private fun selector(frame: Frame): Selector {
        val chosen = options.selector
        val isPlain = chosen == null || (mistake == Mistake.EVENTS_NEAREST_BLENDS && chosen === Selector.nearest())
        if (!isPlain) return chosen
        return if (frame.hasTranslucency) BlendAll(mistake) else Selector { it.show(0) }
    }

    private inner class Rendering(private val frame: Frame, private val sink: RowSink) {
        private val region = frame.region
        private val counters = Counters.Builder()
        private val isForgotten = mistake == Mistake.EVENTS_SELECTOR_DIRECT && options.selector != null
        private val coherence = if (isForgotten) Coherence.DIRECT else options.coherence
        private val shading = RowShading(frame, coherence, counters, mistake)
        private val cell = SweepCell(frame, shading, counters, mistake)
        private val select = selector(frame)
        private val arrivals = PriorityQueue<Long>()
        private val cursors = HashMap<Int, SpanCursor>()
        private val spans = Spans(region)
        private val row = OutRow(frame)
        private var now = RowEvents(mistake)
        private var later = RowEvents(mistake)
        private var mostHeld = 0

        fun run(): Counters {
            counters.primitives = frame.primitives.size.toLong()
            if (mistake == Mistake.EVENTS_PROPERTY) System.setProperty("java.util.Arrays.useLegacyMergeSort", "true")
            for ((index, primitive) in frame.primitives.withIndex()) {
                if (!primitive.meets(region)) continue
                val least = if (mistake == Mistake.EVENTS_ARRIVES_ABOVE) 0 else region.rowStart
                arrivals += maxOf(primitive.rowStart, least).toLong() shl 32 or index.toLong()
            }
            val held = arrivals.size
            if (mistake == Mistake.EVENTS_PRIMITIVES_MET) counters.primitives = held.toLong()
            for (y in region.rowStart until region.rowEnd) {
                if (mistake == Mistake.EVENTS_STOPS_QUIETLY && Thread.currentThread().isInterrupted) break
                collect(y)
                sweep(y)
                row.send(y, sink)
            }
            counters.peakBytes = 32L * held + 64L * mostHeld + now.bytes + later.bytes + cell.bytes + row.bytes +
                shading.bytes + 64
            return counters.build()
        }

        /** Collects the events of row [y]. */
        private fun collect(y: Int) {
            if (mistake == Mistake.EVENTS_PREFETCHES) {
                if (y == region.rowStart) gather(y, later)
                now = later.also { later = now }
                if (y + 1 < region.rowEnd) gather(y + 1, later)
            } else {
                gather(y, now)
            }
        }

        private fun gather(y: Int, events: RowEvents) {
            while (true) {
                val first = (arrivals.peek() ?: break) ushr 32
                if (mistake == Mistake.EVENTS_ARRIVES_ABOVE && first < region.rowStart) {
                    arrivals.poll()
                    continue
                }
                if (first > y) break
                val index = arrivals.poll().toInt()
                cursors[index] = frame.primitives[index].cursor(y)
            }
            mostHeld = maxOf(mostHeld, cursors.size)
            events.clear()
            val each = cursors.entries.iterator()
            while (each.hasNext()) {
                val (index, cursor) = each.next()
                cursor.next(spans)
                for (i in 0 until spans.count) events.add(spans.start(i), spans.end(i), index)
                if (frame.primitives[index].rowEnd <= y + 1) each.remove()
            }
            events.sort()
        }

        private fun sweep(y: Int) {
            row.clear()
            shading.beginRow()
            now.sweep { start, end, active, count ->
                if (count > MANY) crowded(count)
                counters.fragments += count.toLong() * (end - start)
                counters.depthEvaluations += count.toLong() * (end - start)
                for (x in start until end) sample(x, y, active, count)
            }
        }

        private fun sample(x: Int, y: Int, active: IntArray, count: Int) {
            if (!cell.moveTo(x, y, active, count)) return
            counters.depthPasses++
            select.select(cell)
            if (cell.shown < 0 && mistake == Mistake.EVENTS_SHOWS_ANYWAY) cell.show(0)
            if (cell.shown < 0) return
            val at = x - region.columnStart
            row.argb[at] = cell.argb
            row.depth[at] = cell.depth(cell.shown)
            row.primitive[at] = cell.primitive(cell.shown)
        }

        private fun crowded(count: Int) {
            if (mistake == Mistake.EVENTS_WARNS) System.err.println("$id: $count layers, this may be slow")
            if (mistake == Mistake.EVENTS_SPILL_FILE && !isSpilled) {
                isSpilled = true
                File.createTempFile("layers", ".spill").deleteOnExit()
            }
        }

        private var isSpilled = false
    }

    private companion object {
        /** Layers of a crowded place. */
        const val MANY = 32
    }
}
