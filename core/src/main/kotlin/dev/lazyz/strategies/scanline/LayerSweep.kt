package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.shading.LateShading
import dev.lazyz.shading.LayerShading
import dev.lazyz.spi.LinearForm

/**
 * Moves along a row a second time, after [RowSweep], and blends the translucent spans that are before the visible
 * opaque ones.
 *
 * Between two edges of translucent spans, and as long as the same opaque primitive is visible, the candidates stay the
 * same. They are sorted by depth once, at the first sample, if the order is proved to hold up to the last one. If it is
 * not, because surfaces cross, the stretch is halved. Spans without linear depth are sorted at each sample.
 *
 * Source: Gary Watkins, "A Real Time Visible Surface Algorithm", University of Utah (1970), halves spans in this way.
 */
internal class LayerSweep(
    private val frame: Frame,
    private val edges: ActiveEdges,
    private val shading: LateShading,
    private val counters: Counters.Builder,
) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val background = LinearForm.constant(frame.raster.backgroundDepth)
    private val colors = LayerShading(frame, shading)

    /** The translucent primitives at the current column, and how many of them have no linear depth. */
    private var candidates = IntArray(INITIAL)
    private var count = 0
    private var curved = 0

    /** The candidates that are before the backdrop, from near to far, with the values of their depth at both ends. */
    private var layers = IntArray(INITIAL)
    private var firsts = LongArray(INITIAL)
    private var lasts = LongArray(INITIAL)
    private var layerCount = 0

    /** The visible opaque primitive, or the background. */
    private var backdrop = DepthTest.BACKGROUND
    private var backdropFirst = 0L
    private var backdropLast = 0L

    /** Bytes currently held. */
    val bytes: Long get() = (2L * Int.SIZE_BYTES + 2L * Long.SIZE_BYTES) * candidates.size

    /**
     * Computes the colours of row [y]. [depths] and [visible] show the opaque primitives; they are changed to show the
     * nearest fragments. All arrays start at the region's first column. The edges must be at this row.
     */
    fun shadeRow(y: Int, depths: IntArray, visible: IntArray, argb: IntArray) {
        shading.beginRow()
        var edge = nextEdge(0)
        var x = region.columnStart
        while (x < region.columnEnd) {
            // Add spans that start at this column, remove spans that end here
            while (edge < edges.count && edges.column(edge) == x) {
                pass(edge)
                edge = nextEdge(edge + 1)
            }

            // Between two edges, divide the row where another opaque primitive becomes visible
            val spanEnd = if (edge < edges.count) edges.column(edge) else region.columnEnd
            while (x < spanEnd) {
                backdrop = visible[x - region.columnStart]
                var end = x + 1
                while (end < spanEnd && visible[end - region.columnStart] == backdrop) end++
                showStretch(x, end, y, depths, visible, argb)
                x = end
            }
        }
        count = 0
        curved = 0
    }

    /** Returns the first edge from [edge] on that belongs to a translucent primitive. */
    private fun nextEdge(edge: Int): Int {
        var next = edge
        while (next < edges.count && !frame.primitives[edges.primitive(edges.span(next))].isTranslucent) next++
        return next
    }

    private fun pass(edge: Int) {
        val index = edges.primitive(edges.span(edge))
        val change = if (frame.primitives[index].depthForm == null) 1 else 0
        if (edges.isStart(edge)) {
            reserve(count + 1)
            candidates[count++] = index
            curved += change
        } else {
            var at = 0
            while (candidates[at] != index) at++
            candidates[at] = candidates[--count]
            curved -= change
        }
    }

    private fun reserve(size: Int) {
        if (size <= candidates.size) return
        candidates = candidates.copyOf(2 * size)
        layers = IntArray(candidates.size)
        firsts = LongArray(candidates.size)
        lasts = LongArray(candidates.size)
    }

    /** Shows the columns [start] until [end], at which candidates and backdrop are the same. */
    private fun showStretch(start: Int, end: Int, y: Int, depths: IntArray, visible: IntArray, argb: IntArray) {
        val isFlat = curved == 0 && (backdrop == DepthTest.BACKGROUND || form(backdrop) != null)
        var from = start
        while (from < end) {
            layerCount = 0
            var until = if (isFlat || count == 0) end else from + 1
            if (isFlat && count > 0) {
                while (!isSorted(from, until, y)) until = from + (until - from) / 2
            } else if (count > 0) {
                sort(from, y, depths[from - region.columnStart])
            }
            show(from, until, y, depths, visible, argb)
            from = until
        }
    }

    /**
     * Sorts the candidates before the backdrop at column [from]. Returns whether their order is proved up to the column
     * before [until].
     */
    private fun isSorted(from: Int, until: Int, y: Int): Boolean {
        backdropFirst = value(backdrop, from, y)
        backdropLast = if (until == from + 1) backdropFirst else value(backdrop, until - 1, y)
        layerCount = 0
        for (i in 0 until count) {
            endIfInterrupted()
            val index = candidates[i]
            val first = value(index, from, y)
            val last = if (until == from + 1) first else value(index, until - 1, y)
            if (order.key(first, index) < order.key(backdropFirst, backdrop)) {
                insert(index, first, last, order.key(first, index))
            } else if (until > from + 1 && !isProved(backdrop, backdropFirst, backdropLast, index, first, last)) {
                return false
            }
        }
        return until == from + 1 || areLayersProved()
    }

    /** Whether each layer is proved to be before the next one, and the last before the backdrop. */
    private fun areLayersProved(): Boolean {
        for (i in 0 until layerCount) {
            val isLast = i + 1 == layerCount
            val behind = if (isLast) backdrop else layers[i + 1]
            val first = if (isLast) backdropFirst else firsts[i + 1]
            val last = if (isLast) backdropLast else lasts[i + 1]
            if (!isProved(layers[i], firsts[i], lasts[i], behind, first, last)) return false
        }
        return true
    }

    /** Whether one primitive is visible before another all along a stretch, given the values at its ends. */
    private fun isProved(
        front: Int,
        first: Long,
        last: Long,
        behind: Int,
        behindFirst: Long,
        behindLast: Long,
    ): Boolean {
        val needed = order.leastLead(front, behind)
        return order.lead(first, behindFirst) >= needed && order.lead(last, behindLast) >= needed
    }

    /** Sorts the candidates before the backdrop, which has the depth [backdropDepth], at the single column [x]. */
    private fun sort(x: Int, y: Int, backdropDepth: Int) {
        val backdropKey = test.key(backdropDepth, backdrop)
        for (i in 0 until count) {
            endIfInterrupted()
            val index = candidates[i]
            counters.depthEvaluations++
            val depth = frame.primitives[index].depth(x, y)
            val value = depth.toLong() shl 32
            if (test.key(depth, index) < backdropKey) insert(index, value, value, test.key(depth, index))
        }
    }

    /** Inserts a primitive into the layers, which are in the order of their keys at the first column. */
    private fun insert(index: Int, first: Long, last: Long, key: Long) {
        var at = layerCount++
        while (at > 0 && order.key(firsts[at - 1], layers[at - 1]) > key) {
            layers[at] = layers[at - 1]
            firsts[at] = firsts[at - 1]
            lasts[at] = lasts[at - 1]
            at--
        }
        layers[at] = index
        firsts[at] = first
        lasts[at] = last
    }

    /** Shows the layers at the columns [from] until [until]. */
    private fun show(from: Int, until: Int, y: Int, depths: IntArray, visible: IntArray, argb: IntArray) {
        val first = from - region.columnStart
        for (x in from until until) {
            argb[x - region.columnStart] = colors.shade(x, y, layers, layerCount, backdrop)
        }
        if (layerCount == 0) return
        counters.depthPasses += layerCount.toLong() * (until - from)
        visible.fill(layers[0], first, until - region.columnStart)

        // The depth at the first sample is known; step it along the run
        depths[first] = (firsts[0] shr 32).toInt()
        if (until == from + 1) return
        counters.depthEvaluations += until - from - 1
        val step = checkNotNull(form(layers[0])).dx
        var z = firsts[0]
        for (i in first + 1 until until - region.columnStart) {
            z += step
            depths[i] = (z shr 32).toInt()
        }
    }

    /** Evaluates the linear depth of a primitive, or of the background, at a sample that it covers. */
    private fun value(index: Int, x: Int, y: Int): Long {
        if (index != DepthTest.BACKGROUND) counters.depthEvaluations++
        return checkNotNull(form(index)).at(x, y)
    }

    private fun form(index: Int): LinearForm? =
        if (index == DepthTest.BACKGROUND) background else frame.primitives[index].depthForm

    private companion object {
        const val INITIAL = 16
    }
}
