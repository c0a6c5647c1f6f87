package dev.lazyz.strategies.lazy

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.pipeline.Chain
import dev.lazyz.pipeline.Row
import dev.lazyz.requireOpaque
import java.util.stream.Stream
import kotlin.streams.asStream

/**
 * The lazy z-buffer: a chain of coroutines, one for each primitive, through which rows are pulled.
 *
 * A row of cells, each a depth and a suspended colour, starts as background. Every primitive is a stage that takes the
 * upstream rows and gives the downstream ones, in which its own samples are nearer where they are. Nothing happens until
 * somebody demands a row from the end of the chain, and no colour is computed until somebody looks at it: what is hidden is
 * never shaded, rows that are not asked for are never scan-converted. Evaluated in this order, the z-buffer is a scan-line
 * method, which is the paper's point.
 *
 * Memory: the stages of the primitives alive on one row, that row, and 8 bytes for each primitive of the region; nothing
 * grows with the number of rows. Time: proportional to the fragments, plus one resumed coroutine for each primitive and
 * row. Shading calls: the visible samples that are asked for, exactly.
 *
 * Use it for pictures larger than memory, for costly shaders, and to look at some samples or the first rows only. Do not
 * use it where primitives arrive one by one, because the first row needs all of them, nor to use several cores.
 *
 * Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), sections 2 to 4. There a lazy functional
 * language suspends lists and colours; here [sequence] suspends rows, and a row has its spans of cells transformed at once.
 *
 * @property options of which [RenderOptions.coherence] is heeded
 */
public class LazyZBuffer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    override val id: String get() = "lazy"

    override val summary: String get() = "rows pulled through a chain of coroutines, one a primitive; colours on demand"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): LazyZBuffer = LazyZBuffer(options)

    override fun render(frame: Frame, sink: RowSink): Counters {
        var counters = Counters()
        for (row in rows(frame)) {
            row.sendTo(sink)
            counters = counters.plus(row.counters)
        }
        return counters
    }

    /**
     * Returns the rows of [frame]'s region from the top, each made when it is asked for: taking the first k of them does
     * the work of k rows, and no colour is computed before [Row.argb] asks for it. For rows further down, or for a few
     * columns, narrow the frame down with [Frame.within]; then the rest costs nothing either.
     *
     * The sequence may be walked any number of times, and by several threads at once; each walk starts anew.
     *
     * @throws IllegalArgumentException if a primitive is translucent
     */
    public fun rows(frame: Frame): Sequence<Row> {
        requireOpaque(frame, this)
        return sequence {
            val chain = Chain(frame, options.coherence, ::LazyStage)
            for (y in frame.region.rowStart until frame.region.rowEnd) {
                // Demand has reached the upstream end; the row runs down the chain
                var row = chain.begin(y)
                for (i in 0 until chain.size) row = chain[i].next(row)
                chain.end(row)
                yield(row)
            }
        }
    }

    /** Returns the rows of [frame] as [rows] does, for Java. Sequential; to be walked once. */
    public fun stream(frame: Frame): Stream<Row> = rows(frame).asStream()

    override fun toString(): String = "LazyZBuffer($options)"
}
