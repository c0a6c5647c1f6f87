package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans

/** Row by row: a list of the primitives that are alive on the row, a key a column, shading by steps along the row. */
internal open class SweepDrawing(frame: Frame, val coherence: Coherence) : Drawing(frame) {
    class Entry(val index: Int, val primitive: Primitive, val cursor: SpanCursor)

    class Chain(val cursor: ShadingCursor, var x: Int)

    val spans = region.spans()
    open val keys = LongArray(width)
    val active = ArrayList<Entry>()
    val chains = HashMap<Int, Chain>()
    var arrivals = emptyList<Int>()
    var arrived = 0

    override fun run(sink: RowSink): Counters {
        counters.primitives = primitives.size.toLong()
        arrivals = arrivals()
        for (y in region.rowStart until region.rowEnd) doRow(y, sink)
        return counters.build()
    }

    open fun doRow(y: Int, sink: RowSink) {
        drawRow(y)
        finishRow(keys, 0, y, sink)
    }

    open fun drawRow(y: Int) {
        keys.fill(backgroundKey())
        admit(y)
        val bytes = 20L * width + 8L * arrivals.size + 64L * active.size
        counters.peakBytes = maxOf(counters.peakBytes, bytes)
        drawActive(y)
        retire(y)
    }

    fun firstRow(index: Int): Int = maxOf(primitives[index].rowStart, region.rowStart)

    /** Indices of the primitives that reach the region, by first row. */
    open fun arrivals(): List<Int> = primitives.indices.filter { reaches(primitives[it]) }.sortedBy { firstRow(it) }

    open fun admit(y: Int) {
        while (arrived < arrivals.size && firstRow(arrivals[arrived]) <= y) enter(arrivals[arrived++], y)
    }

    open fun enter(index: Int, y: Int) {
        active.add(Entry(index, primitives[index], primitives[index].cursor(y)))
    }

    open fun drawActive(y: Int) {
        for (entry in active) draw(entry, y)
    }

    open fun draw(entry: Entry, y: Int) {
        entry.cursor.next(spans)
        for (i in 0 until spans.count) drawSpan(entry.primitive, entry.index, y, spans.start(i), spans.end(i))
    }

    open fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        count(start, end)
        walk(primitive, y, start, end)
        lower(keys, start - region.columnStart, index, end - start)
    }

    open fun retire(y: Int) {
        active.removeIf { it.primitive.rowEnd <= y + 1 }
    }

    override fun colorRow(y: Int) {
        beginShading()
        val visible = indices.count { it != DepthTest.BACKGROUND }
        counters.peakSuspensions = maxOf(counters.peakSuspensions, visible.toLong())
        super.colorRow(y)
    }

    open fun beginShading() = chains.clear()

    override fun color(index: Int, x: Int, y: Int): Int {
        val primitive = primitives[index]
        val cursor = if (isStepping(primitive)) cursor(index, x, y) else null
        if (cursor == null) return super.color(index, x, y)
        counters.shadingCalls++
        fragment.moveTo(x, y)
        cursor.shade(fragment)
        return fragment.toArgb()
    }

    open fun isStepping(primitive: Primitive): Boolean = when (coherence) {
        Coherence.DIRECT -> false
        Coherence.INCREMENTAL -> true
        Coherence.ADAPTIVE -> primitive.shadingStartCost > 0
    }

    open fun isNear(gap: Int, primitive: Primitive): Boolean =
        coherence == Coherence.INCREMENTAL || gap <= primitive.shadingStartCost

    /** Steps to column [x], or starts there. */
    private fun cursor(index: Int, x: Int, y: Int): ShadingCursor? {
        val primitive = primitives[index]
        val chain = chains[index]
        if (chain != null && isNear(x - chain.x, primitive)) {
            step(chain, x)
            return chain.cursor
        }
        val cursor = primitive.shadingCursor(x, y) ?: return null
        counters.shadingStarts++
        chains[index] = Chain(cursor, x)
        return cursor
    }

    open fun step(chain: Chain, x: Int) {
        val gap = x - chain.x
        repeat(gap) { chain.cursor.step() }
        chain.x = x
        counters.shadingSteps += gap
        counters.longestChain = maxOf(counters.longestChain, gap.toLong())
    }
}

internal val SWEEP_PROMISES = setOf(
    Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.COHERENCE,
)

internal fun sweep(drawing: (Frame, Coherence) -> SweepDrawing): Renderer =
    Workbench("sweep", { SWEEP_PROMISES }) { frame, options -> drawing(frame, options.coherence) }
