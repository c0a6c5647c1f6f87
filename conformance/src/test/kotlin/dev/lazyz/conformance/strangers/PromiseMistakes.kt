package dev.lazyz.conformance.strangers

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Spans

/** Promises that are not kept, and options that change what they must not. */
internal val promiseMistakes: List<Stranger> = listOf(
    Stranger(
        "memory-bucket-a-row",
        "arrivals are sorted into a list for each row: memory grows with the rows",
        setOf("7.6"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun arrivals(): List<Int> {
                    val buckets = Array(region.height) { ArrayList<Int>(0) }
                    for (index in super.arrivals()) buckets[firstRow(index) - region.rowStart].add(index)
                    return buckets.flatMap { it }
                }

                override fun run(sink: RowSink): Counters =
                    super.run(sink).toBuilder().apply { peakBytes += 24L * region.height }.build()
            }
        }
    },
    Stranger(
        "memory-keeps-rows",
        "the indices of all rows are kept and not reported; shows in memory that is in use while a tall region is rendered",
        setOf("7.6", "8.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private val rows = ArrayList<IntArray>()

                override fun handOut(y: Int, sink: RowSink) {
                    rows.add(indices.clone())
                    super.handOut(y, sink)
                }
            }
        }
    },
    Stranger(
        "memory-never-retires",
        "primitives that have ended stay in the active list; reported, so peak bytes grow with the rows of a long scene",
        setOf("7.6"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun retire(y: Int) = Unit

                override fun draw(entry: Entry, y: Int) {
                    if (y < entry.primitive.rowEnd) super.draw(entry, y)
                }
            }
        }
    },
    Stranger(
        "streams-looks-a-row-ahead",
        "the next row's spans are asked for before a row is handed out",
        setOf("7.6"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private val ahead = Spans(region)

                override fun draw(entry: Entry, y: Int) {
                    super.draw(entry, y)
                    ahead.clear()
                    if (y + 1 < minOf(entry.primitive.rowEnd, region.rowEnd)) entry.primitive.spans(y + 1, ahead)
                }
            }
        }
    },
    Stranger(
        "streams-tests-last-row",
        "each primitive is asked for its last row first, to see whether it covers it",
        setOf("7.6"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun enter(index: Int, y: Int) {
                    val last = minOf(primitives[index].rowEnd, region.rowEnd) - 1
                    primitives[index].spans(last, Spans(region))
                    super.enter(index, y)
                }
            }
        }
    },
    Stranger("streams-two-rows-at-once", "rows are drawn and shaded in pairs, then handed out", setOf("7.6")) {
        Workbench("tiles", { setOf(Capability.SHADES_ONLY_VISIBLE, Capability.STREAMS_ROWS) }) { frame, _ ->
            TileDrawing(frame, 2)
        }
    },
    Stranger(
        "streams-keeps-primitives",
        "a reference to each primitive is kept: hidden ones take memory",
        setOf("7.6"),
    ) {
        plain {
            object : PlainDrawing(it) {
                private val kept = ArrayList<Primitive>()

                override fun draw(primitive: Primitive, index: Int) {
                    kept.add(primitive)
                    counters.peakBytes += 8
                    super.draw(primitive, index)
                }
            }
        }
    },
    Stranger(
        "shades-nearest-so-far",
        "declares to shade only what is visible, and shades what is nearer so far",
        setOf("8.2"),
    ) {
        Workbench("plain", { setOf(Capability.SHADES_ONLY_VISIBLE) }) { frame, _ ->
            object : PlainDrawing(frame) {
                override fun color(index: Int, x: Int, y: Int): Int {
                    counters.shadingStarts++
                    return super.color(index, x, y)
                }
            }
        }
    },
    Stranger("budget-least-256", "there is room for 256 waiting samples whatever the budget", setOf("7.6")) {
        waiting { frame, options ->
            object : WaitingDrawing(frame, options) {
                override fun capacity(): Int = maxOf(super.capacity(), 256)
            }
        }
    },
    Stranger("budget-next-power-of-two", "room is made for the next power of two of waiting samples", setOf("7.6")) {
        waiting { frame, options ->
            object : WaitingDrawing(frame, options) {
                override fun capacity(): Int =
                    super.capacity().let { if (it == 0) 0 else it.takeHighestOneBit() * 2 }
            }
        }
    },
    Stranger("budget-in-places", "the budget is taken for a number of samples; each takes four bytes", setOf("7.6")) {
        waiting { frame, options ->
            object : WaitingDrawing(frame, options) {
                override fun capacity(): Int = minOf(budget ?: Long.MAX_VALUE, keys.size.toLong()).toInt()
            }
        }
    },
    Stranger(
        "budget-full-loses-sample",
        "a sample that finds no room waits for nothing and keeps its old colour; shows under small budgets",
        setOf("7.5"),
    ) {
        waiting { frame, options ->
            object : WaitingDrawing(frame, options) {
                override fun show(at: Int, index: Int, x: Int, y: Int) {
                    if (count < capacity || capacity == 0) super.show(at, index, x, y)
                }
            }
        }
    },
    Stranger(
        "budget-flush-forgets-last",
        "a flush shades all but the newest waiting sample; shows under budgets that make it flush",
        setOf("7.5"),
    ) {
        waiting { frame, options ->
            object : WaitingDrawing(frame, options) {
                override fun flush() {
                    if (count > 1 && count == capacity && capacity < keys.size) count--
                    super.flush()
                }
            }
        }
    },
    Stranger(
        "options-in-place",
        "configured() changes the renderer itself; the old one follows the new selector",
        setOf("7.5", "7.1"),
    ) {
        OptionsInPlace()
    },
)

/** Keeps the options that it was given last. */
private class OptionsInPlace : Renderer {
    private var options = RenderOptions()

    override val id: String get() = "sample-lists"
    override val summary: String get() = "a renderer of somebody else"
    override val capabilities: Set<Capability> get() = listPromises(options)

    override fun configured(options: RenderOptions): Renderer = apply {
        this.options = options.requireSupportedBy(this)
    }

    override fun render(frame: Frame, sink: RowSink): Counters = ListDrawing(frame, options.selector).run(sink)
}
