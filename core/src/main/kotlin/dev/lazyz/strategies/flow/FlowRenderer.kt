package dev.lazyz.strategies.flow

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.pipeline.Chain
import dev.lazyz.pipeline.LazyRow
import dev.lazyz.pipeline.Stage
import dev.lazyz.requireInMemory
import dev.lazyz.requireOpaque
import java.io.IOException
import kotlin.coroutines.CoroutineContext
import kotlinx.coroutines.currentCoroutineContext
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.runBlocking

/**
 * The lazy z-buffer's pipeline as a [Flow]: rows are emitted to a collector when the collector is ready for them.
 *
 * The stages, the order of evaluation, the work and the memory are those of `LazyRenderer`; the difference is in
 * control. The producer is suspended while the collector works. A slow collector (a network, a disk) therefore slows
 * down the producer, and at most one row is in progress. Cancelling the collector's coroutine stops the producer within
 * a row, at the next stage.
 *
 * Use it in coroutine-based code, for long renderings that may be cancelled, and to feed a suspending consumer.
 * Elsewhere use `LazyRenderer`, which does the same without suspending. Neither uses several cores to make the rows of
 * one picture. Colours, however, can be computed on another thread: insert [kotlinx.coroutines.flow.buffer] and shade
 * the rows in the collector.
 *
 * Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), sections 2 to 4. In the paper,
 * demand is the only form of control; here the flow adds cancellation and back pressure.
 *
 * @property options only [RenderOptions.coherence] is used
 */
public class FlowRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "flow"

    override val summary: String get() = "the lazy pipeline as a Flow: cancellable, and a slow collector holds it back"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): FlowRenderer = FlowRenderer(options)

    /**
     * Renders [frame] and passes every row to [sink], on this thread.
     *
     * @throws InterruptedException if the thread is interrupted, also within a row; the sink then receives no further
     *   rows
     */
    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters = runBlocking {
        rows(frame) { Checkpoint.CALLER }.deliver(sink, Checkpoint.CALLER)
    }

    /**
     * Renders [frame] and passes every row to [sink] in the caller's context, as [render] does, for coroutines. If the
     * coroutine is cancelled, the sink receives no further rows.
     */
    @JvmSynthetic
    public suspend fun renderSuspending(frame: Frame, sink: RowSink): Counters =
        rows(frame).deliver(sink, Checkpoint.NONE)

    /**
     * Returns the rows of [frame]'s region from the top. Each row is made when the collector is ready for it, and
     * shaded when [LazyRow.argb] is read.
     *
     * The flow is cold: each collection starts from the beginning with its own state, so the flow can be collected
     * several times, also concurrently. It runs in the collector's context and suspends only in the collector. To make
     * rows in another context or in advance, add [kotlinx.coroutines.flow.flowOn] or [kotlinx.coroutines.flow.buffer];
     * the buffer's capacity is then the number of rows that may wait. Cancellable between any two stages of a row.
     *
     * @throws IllegalArgumentException if a primitive is translucent
     */
    public fun rows(frame: Frame): Flow<LazyRow> = rows(frame) { context -> Checkpoint { context.ensureActive() } }

    /** The pipeline. It passes the checkpoint that [checkpointIn] returns before each stage. */
    private fun rows(frame: Frame, checkpointIn: (CoroutineContext) -> Checkpoint): Flow<LazyRow> {
        requireOpaque(frame, this)
        requireInMemory(frame, this)
        return flow {
            val checkpoint = checkpointIn(currentCoroutineContext())
            val chain = Chain(frame, options.coherence, checkpoint, ::Stage)
            // Each waits until the collector has processed the row
            for (y in frame.region.rowStart until frame.region.rowEnd) emit(chain.row(y))
        }
    }

    private suspend fun Flow<LazyRow>.deliver(sink: RowSink, checkpoint: Checkpoint): Counters {
        val counters = Counters.Builder()
        collect { row ->
            row.sendTo(sink, checkpoint)
            counters.add(row.counters)
        }
        return counters.build()
    }

    override fun toString(): String = "FlowRenderer($options)"
}
