package dev.lazyz.strategies.scanline

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.requireOpaque
import dev.lazyz.shading.LateShading

/**
 * Row by row, and along a row from edge to edge: between two edges one comparison of depth decides all samples.
 *
 * Primitives wait in the order of their first rows; those that the row cuts are active, and their spans' ends are
 * edges, kept in order of columns from row to row. Along the row a tournament among the active primitives holds the
 * visible one; it is replayed where an edge is passed or two surfaces cross, and nowhere else. What is visible is
 * shaded once the row is decided.
 *
 * Use it where primitives are larger than a few samples, or lie in many layers: its depth evaluations grow with
 * visible samples and edges, not with fragments. Use it for pictures that are larger than memory. For very small
 * triangles a row has as many edges as fragments, and a depth buffer does the same for less.
 *
 * Memory: a row, and the primitives the row cuts; 8 bytes for each primitive that waits. Time: for a row of k spans
 * O(k log k), and O(log k) for each sample where two surfaces are within one unit of depth; besides, where depth is no
 * linear form, its evaluation. Thread safe; no state between calls.
 *
 * Source: Chris Wylie, Gordon Romney, David Evans, Alan Erdahl, "Half-tone perspective drawings by computer", AFIPS
 * Fall Joint Computer Conference 31 (1967), and Gary Watkins, "A Real Time Visible Surface Algorithm", University of
 * Utah (1970), for spans; the tournament is that of Julien Basch, Leonidas Guibas and John Hershberger, "Data
 * structures for mobile data", 8th ACM-SIAM Symposium on Discrete Algorithms (1997), with columns for time. Watkins
 * halves a span until one surface is visible all along it; here a comparison tells the column until which it holds,
 * exactly.
 *
 * @param options [RenderOptions.coherence] is heeded
 */
public class ScanLine @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    override val id: String get() = "scanline"

    override val summary: String get() = "row by row from edge to edge, depth compared once where nothing crosses"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.CONSTANT_MEMORY,
            Capability.STREAMS_ROWS,
            Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): Renderer = ScanLine(options)

    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val counters = Counters()
        counters.primitives = frame.primitives.size.toLong()
        val edges = ActiveEdges(frame, counters)
        val sweep = RowSweep(frame, edges, counters)
        val shading = LateShading(frame, options.coherence, counters)
        val colors = IntArray(frame.width)
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            // Step every active edge to this row
            edges.moveTo(y)

            // Decide what is visible, from edge to edge
            sweep.sweep(y)
            counters.peakBytes = maxOf(counters.peakBytes, edges.bytes + sweep.bytes)

            // Only now make the colours
            val shadedBefore = counters.shadingCalls
            shading.shadeRow(y, sweep.indices, colors)
            counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
            sink.row(y, colors, sweep.depths, sweep.indices)
        }
        counters.peakBytes += shading.peakBytes + Int.SIZE_BYTES * frame.width
        return counters
    }

    override fun toString(): String = "ScanLine($options)"
}
