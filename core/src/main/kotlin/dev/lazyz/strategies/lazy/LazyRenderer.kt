package dev.lazyz.strategies.lazy

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.pipeline.Chain
import dev.lazyz.pipeline.LazyRow
import dev.lazyz.pipeline.Stage
import dev.lazyz.requireInMemory
import dev.lazyz.requireOpaque
import dev.lazyz.spi.Spans
import java.io.IOException
import java.util.stream.Stream
import kotlin.streams.asStream

/**
 * The lazy z-buffer: rows are pulled through a chain of coroutines, one for each primitive.
 *
 * A row consists of cells, each with a depth and a suspended colour, and starts as background. Every primitive is a
 * stage that turns upstream rows into downstream rows: it replaces the cells where its own samples are nearer. Nothing
 * is computed until a row is requested from the end of the chain, and no colour is computed until it is read. Hidden
 * samples are therefore never shaded, and rows that are not requested are never scan-converted. With this order of
 * evaluation the z-buffer becomes a scan-line method, which is the main result of the paper.
 *
 * Memory: the stages of the primitives that are active on one row, that row, and 8 bytes for each primitive of the
 * region; nothing grows with the number of rows. With [RenderOptions.memoryBudget], stages are suspended only as long
 * as they fit. The other primitives are begun again on each of their rows, which takes time and nothing else: picture
 * and shading calls are the same, and rows still arrive one by one. Time: proportional to the number of fragments, plus
 * one resumed coroutine for each primitive and row. Shading calls: exactly one for each visible sample whose colour is
 * read.
 *
 * Use it for pictures larger than memory, for expensive shaders, and to compute only some samples or only the first
 * rows. Do not use it where primitives arrive one by one, because the first row needs all of them, or to use several
 * cores.
 *
 * Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), sections 2 to 4. In the paper, a
 * lazy functional language suspends lists and colours; here [sequence] suspends rows, and all cells of a span are
 * transformed at once.
 *
 * @property options only [RenderOptions.coherence] and [RenderOptions.memoryBudget] are used
 */
public class LazyRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "lazy"

    override val summary: String get() = "rows pulled through a chain of coroutines, one a primitive; colours on demand"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.CONSTANT_MEMORY,
            Capability.STREAMS_ROWS,
            Capability.MEMORY_BUDGET,
            Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): LazyRenderer = LazyRenderer(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        val counters = Counters.Builder()
        for (row in rows(frame, Checkpoint.CALLER)) {
            row.sendTo(sink, Checkpoint.CALLER)
            counters.add(row.counters)
        }
        return counters.build()
    }

    /**
     * Returns the rows of [frame]'s region from the top. Each row is made when it is requested: taking the first k rows
     * does the work of k rows, and no colour is computed before [LazyRow.argb] is read. To compute only rows further
     * down, or only some columns, narrow the frame with [Frame.within]; the rest then costs nothing.
     *
     * The sequence can be iterated any number of times, also by several threads at once; each iteration starts from the
     * beginning.
     *
     * @throws IllegalArgumentException if a primitive is translucent
     */
    public fun rows(frame: Frame): Sequence<LazyRow> = rows(frame, Checkpoint.NONE)

    private fun rows(frame: Frame, checkpoint: Checkpoint): Sequence<LazyRow> {
        requireOpaque(frame, this)
        requireInMemory(frame, this)
        return sequence {
            val chain = Chain(frame, options.coherence, checkpoint, ::LazyStage, options.memoryBudget)
            // A request has reached the upstream end: the row is passed down the chain
            for (y in frame.region.rowStart until frame.region.rowEnd) yield(chain.row(y))
        }
    }

    /** Returns the rows of [frame] as [rows] does, for Java. The stream is sequential and can be used once. */
    public fun stream(frame: Frame): Stream<LazyRow> = rows(frame).asStream()

    override fun toString(): String = "LazyRenderer($options)"
}

/**
 * A stage that is a coroutine: between two rows it is suspended in the middle of its primitive.
 *
 * In the paper each stage demands its upstream row itself. A demand at the end of the chain thus becomes as many nested
 * calls as there are stages, and no other work happens on the way up. Here [next] receives the upstream row: the caller
 * starts at the upstream end, where that demand would have arrived, and resumes the stages in the order in which the
 * nested calls would have returned. The evaluations and their order are the same as in the paper, but the stack does
 * not grow with the chain.
 */
internal class LazyStage(frame: Frame, index: Int, y: Int, spans: Spans) : Stage(frame, index, y, spans) {
    /** The next upstream row. */
    private val upstream = Upstream()
    private val downstream = rows(y, upstream).iterator()

    override val bytes: Long get() = super.bytes + HeapLayout.COROUTINE

    override fun next(upstream: LazyRow): LazyRow {
        this.upstream.row = upstream
        return downstream.next()
    }

    /** Returns the downstream rows: the upstream rows with this primitive drawn. */
    private fun rows(y: Int, upstream: Iterator<LazyRow>): Sequence<LazyRow> = sequence {
        repeat(rowEnd - y) { yield(transform(upstream.next())) }
    }

    private class Upstream : Iterator<LazyRow> {
        var row: LazyRow? = null

        override fun hasNext(): Boolean = row != null

        override fun next(): LazyRow = row!!.also { row = null }
    }
}
