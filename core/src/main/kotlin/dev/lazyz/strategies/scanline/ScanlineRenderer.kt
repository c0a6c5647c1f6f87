package dev.lazyz.strategies.scanline

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.endIfInterrupted
import dev.lazyz.requireInMemory
import dev.lazyz.shading.LateShading
import java.io.IOException

/**
 * Works row by row, and along a row from edge to edge: between two edges, one comparison of depth decides all samples.
 *
 * Primitives are sorted by their first rows. Those that the current row intersects are active. The ends of their spans
 * are the edges, which are kept in order of columns from row to row. Along the row, a tournament among the active
 * primitives determines the visible one. It is replayed only where an edge is passed or two surfaces cross. The samples
 * of a row are shaded after the visible primitives of the row are known.
 *
 * Translucent spans do not take part in the tournament. Where they are before what is visible of the opaque ones, they
 * are sorted by depth, once between two edges unless they cross, and blended.
 *
 * Use it where primitives are larger than a few samples, or lie in many layers: the number of depth evaluations grows
 * with visible samples and edges, not with fragments. Use it also for pictures larger than memory. For very small
 * triangles a row has as many edges as fragments, and a depth buffer does less work.
 *
 * Memory: a row, and the primitives that the row intersects; 8 bytes for each primitive that is not yet active. Time:
 * for a row of k spans O(k log k), and O(log k) for each sample where two surfaces are within one unit of depth; in
 * addition, the evaluation of depths that are not linear forms. Thread safe; no state between calls.
 *
 * Source: Chris Wylie, Gordon Romney, David Evans, Alan Erdahl, "Half-tone perspective drawings by computer", AFIPS
 * Fall Joint Computer Conference 31 (1967), and Gary Watkins, "A Real Time Visible Surface Algorithm", University of
 * Utah (1970), for spans. The tournament is that of Julien Basch, Leonidas Guibas and John Hershberger, "Data
 * structures for mobile data", 8th ACM-SIAM Symposium on Discrete Algorithms (1997), with columns in place of time.
 * Watkins halves a span until one surface is visible along all of it; here a comparison yields the exact column until
 * which its result holds.
 *
 * @param options only [RenderOptions.coherence] is used
 */
public class ScanlineRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) :
    Renderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "scanline"

    override val summary: String get() = "row by row from edge to edge, depth compared once where nothing crosses"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.CONSTANT_MEMORY,
            Capability.STREAMS_ROWS,
            Capability.TRANSPARENCY,
            Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): Renderer = ScanlineRenderer(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireInMemory(frame, this)
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val edges = ActiveEdges(frame, counters)
        val sweep = RowSweep(frame, edges, counters)
        val shading = LateShading(frame, options.coherence, counters, Checkpoint.CALLER)
        val layers = if (frame.hasTranslucency) LayerSweep(frame, edges, shading, counters) else null
        val colors = IntArray(frame.width)
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            endIfInterrupted()

            // Step every active edge to this row
            edges.moveTo(y)

            // Determine what is visible, from edge to edge
            sweep.sweep(y)

            // Shade after the visible primitives are known
            val shadedBefore = counters.shadingCalls
            if (layers == null) {
                shading.shadeRow(y, sweep.indices, colors)
            } else {
                layers.shadeRow(y, sweep.depths, sweep.indices, colors)
            }
            counters.peakBytes = maxOf(counters.peakBytes, edges.bytes + sweep.bytes + (layers?.bytes ?: 0))
            counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
            sink.row(y, colors, sweep.depths, sweep.indices)
        }
        counters.peakBytes += shading.peakBytes + Int.SIZE_BYTES * frame.width
        return counters.build()
    }

    override fun toString(): String = "ScanlineRenderer($options)"
}
