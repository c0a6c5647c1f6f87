package dev.lazyz.strategies.flow

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.pipeline.Chain
import dev.lazyz.pipeline.Row
import dev.lazyz.pipeline.Stage
import dev.lazyz.requireOpaque
import kotlin.coroutines.CoroutineContext
import kotlinx.coroutines.currentCoroutineContext
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.runBlocking

/**
 * The lazy z-buffer's pipeline as a [Flow]: rows are emitted to a collector as they are ready, and no sooner than it wants
 * them.
 *
 * The stages, the order of evaluation, the work and the memory are those of `LazyZBuffer`; what differs is who waits for
 * whom. The producer is suspended while the collector is at work, so a slow collector (a network, a disk) holds it back and
 * at most one row is under way. Cancelling the collector's coroutine stops the producer within a row, at the next stage.
 *
 * Use it in code that is made of coroutines, for long renderings that somebody may call off, and to feed a suspending
 * consumer. Elsewhere `LazyZBuffer` does the same without suspending. Neither uses several cores for one picture; colours
 * may be computed elsewhere, though: put [kotlinx.coroutines.flow.buffer] between, and shade the rows in the collector.
 *
 * Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), sections 2 to 4. There demand is the
 * only control; here cancelling and back pressure come with the flow.
 *
 * @property options of which [RenderOptions.coherence] is heeded
 */
public class FlowPipeline @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    override val id: String get() = "flow"

    override val summary: String get() = "the lazy pipeline as a Flow: cancellable, and a slow collector holds it back"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): FlowPipeline = FlowPipeline(options)

    /**
     * Renders [frame] and hands every row to [sink], on this thread.
     *
     * @throws InterruptedException if the thread is interrupted, within a row; the sink gets no further row then
     */
    @Throws(InterruptedException::class)
    override fun render(frame: Frame, sink: RowSink): Counters = runBlocking {
        rows(frame) {
            if (Thread.interrupted()) throw InterruptedException("interrupted while rendering")
        }.deliver(sink)
    }

    /**
     * Renders [frame] and hands every row to [sink], in the caller's context: what [render] does, for coroutines. When the
     * coroutine is cancelled the sink gets no further row.
     */
    public suspend fun renderSuspending(frame: Frame, sink: RowSink): Counters = rows(frame).deliver(sink)

    /**
     * Returns the rows of [frame]'s region from the top, each made when the collector is ready for it, and coloured when
     * [Row.argb] asks for it.
     *
     * The flow is cold: each collection starts anew with state of its own, so it may be collected twice, also at the same
     * time. It runs in the collector's context and suspends in the collector only; to make rows elsewhere, or ahead, add
     * [kotlinx.coroutines.flow.flowOn] or [kotlinx.coroutines.flow.buffer], whose capacity is then the number of rows that
     * may wait. Cancellable between any two stages of a row.
     *
     * @throws IllegalArgumentException if a primitive is translucent
     */
    public fun rows(frame: Frame): Flow<Row> = rows(frame, CoroutineContext::ensureActive)

    /** The pipeline; [checkpoint] is passed before each stage and throws if it is to stop. */
    private fun rows(frame: Frame, checkpoint: (CoroutineContext) -> Unit): Flow<Row> {
        requireOpaque(frame, this)
        return flow {
            val context = currentCoroutineContext()
            val chain = Chain(frame, options.coherence, ::Stage)
            for (y in frame.region.rowStart until frame.region.rowEnd) {
                // Run a row of background down the chain
                checkpoint(context)
                var row = chain.begin(y)
                for (i in 0 until chain.size) {
                    checkpoint(context)
                    row = chain[i].next(row)
                }
                chain.end(row)

                // Wait until the collector is done with it
                emit(row)
            }
        }
    }

    private suspend fun Flow<Row>.deliver(sink: RowSink): Counters {
        var counters = Counters()
        collect { row ->
            row.sendTo(sink)
            counters = counters.plus(row.counters)
        }
        return counters
    }

    override fun toString(): String = "FlowPipeline($options)"
}
