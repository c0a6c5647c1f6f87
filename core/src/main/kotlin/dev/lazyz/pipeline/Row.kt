package dev.lazyz.pipeline

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.shading.LateShading

/**
 * A row of cells, each a depth and a suspended colour: what the pull renderers hand out, one row at a time.
 *
 * Which primitive is visible, and how deep, is known for every column. A colour is computed when it is first asked for,
 * and kept: whoever looks at one column makes one shading call, whoever looks at none makes none. Columns are those of
 * the raster, [columnStart] until [columnEnd], which is the region's width.
 *
 * A row owns its cells: it stays valid when the next row is pulled, and as long as it is kept. Thread safe. Memory: 8
 * bytes a column, and 4 more once colours have been asked for.
 *
 * Use [Renderer.render] for whole pictures; use rows to stream them, to stop early, or to look at some samples only. Come
 * by one through `LazyZBuffer.rows` or `FlowPipeline.rows`.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 2. There a cell is a pair of
 * a depth and an unevaluated colour; here it is one visibility key, in which the primitive's index is the suspension:
 * with the sample it determines the colour (contract rule 6.1).
 *
 * @property y the row of the raster
 */
public class Row internal constructor(private val frame: Frame, public val y: Int, private val coherence: Coherence,) {
    /**
     * What was done for this row alone: by the renderer to make it, and since then to colour it. Added up over all rows
     * ([Counters.plus]) they are the counters of the whole rendering; the first row brings the number of primitives.
     */
    public val counters: Counters = Counters()

    /** First column of the row. */
    public val columnStart: Int get() = frame.region.columnStart

    /** The column after the last of the row. */
    public val columnEnd: Int get() = frame.region.columnEnd

    /** Number of columns. */
    public val width: Int get() = frame.region.width

    internal val test = frame.raster.depthTest
    private val background = frame.raster.background.toArgb()

    /** The cells, from [columnStart] on. Stages lower them while the row runs down the chain; nobody does afterwards. */
    internal val keys = LongArray(width)

    /** Bytes that the renderer and this row hold. */
    private var bytes = Long.SIZE_BYTES * keys.size.toLong()

    /** The colours computed so far. */
    private var colors: IntArray? = null

    /** Which columns have their colour, one bit a column; null if none or all have. */
    private var forced: LongArray? = null
    private var isWhole = false

    /** Computes single colours. */
    private var single: LateShading? = null

    init {
        keys.fill(test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND))
    }

    /** Returns the depth at column [x], 0..2^31-1, see [Depth]. Shades nothing. */
    public fun depth(x: Int): Int = test.depthOf(keys[at(x)])

    /** Returns the index of the primitive visible at column [x], or [DepthTest.BACKGROUND]. Shades nothing. */
    public fun primitive(x: Int): Int = test.indexOf(keys[at(x)])

    /**
     * Returns the colour at column [x], `0xAARRGGBB`: one shading call if it is asked for the first time and a primitive
     * is visible there. Evaluated by itself, under any [Coherence].
     */
    @Synchronized
    public fun argb(x: Int): Int {
        val at = at(x)
        val colors = colors()
        if (isWhole) return colors[at]

        // Force the suspension, unless it has been
        val forced = forced()
        if (!isForced(forced, at)) {
            val shading = single ?: LateShading(frame, Coherence.DIRECT, counters).also { single = it }
            colors[at] = color(at, shading)
            forced[at / Long.SIZE_BITS] = forced[at / Long.SIZE_BITS] or (1L shl at)
        }
        return colors[at]
    }

    /**
     * Returns all colours, `0xAARRGGBB`, from [columnStart] on: one shading call for each visible sample that has not
     * been shaded yet, from left to right, with the renderer's [Coherence]. The array is the row's own and must not be
     * changed.
     */
    @Synchronized
    public fun argb(): IntArray {
        val colors = colors()
        if (isWhole) return colors
        val shading = LateShading(frame, coherence, counters)
        val forced = forced
        for (i in 0 until width) if (forced == null || !isForced(forced, i)) colors[i] = color(i, shading)
        account(shading.peakBytes)

        // From here on there is nothing left to force
        isWhole = true
        single = null
        bytes -= Long.SIZE_BYTES * (forced?.size ?: 0).toLong()
        this.forced = null
        return colors
    }

    /** Hands this row to [sink], all colours computed. The sink must leave the arrays alone. */
    public fun sendTo(sink: RowSink) {
        val colors = argb()
        val depths = IntArray(width)
        val indices = IntArray(width)
        for (i in 0 until width) {
            depths[i] = test.depthOf(keys[i])
            indices[i] = test.indexOf(keys[i])
        }
        account(2L * Int.SIZE_BYTES * width)
        sink.row(y, colors, depths, indices)
    }

    override fun toString(): String = "Row($y, columns $columnStart..<$columnEnd, $counters)"

    private fun colors(): IntArray = colors ?: IntArray(width).also {
        colors = it
        hold(Int.SIZE_BYTES * it.size.toLong())
    }

    private fun forced(): LongArray = forced ?: LongArray((width + Long.SIZE_BITS - 1) / Long.SIZE_BITS).also {
        forced = it
        hold(Long.SIZE_BYTES * it.size.toLong())
    }

    private fun isForced(forced: LongArray, at: Int): Boolean = forced[at / Long.SIZE_BITS] ushr at and 1L != 0L

    private fun color(at: Int, shading: LateShading): Int {
        val index = test.indexOf(keys[at])
        return if (index == DepthTest.BACKGROUND) background else shading.shade(columnStart + at, y, index)
    }

    /** Enters [more] bytes into the counters, held from now on. */
    internal fun hold(more: Long) {
        bytes += more
        account(0)
    }

    /** Enters [passing] bytes into the counters, on top of those that are held. */
    @Synchronized
    private fun account(passing: Long) {
        counters.peakBytes = maxOf(counters.peakBytes, bytes + passing)
    }

    private fun at(x: Int): Int {
        require(x in columnStart until columnEnd) { "column must be in $columnStart..<$columnEnd: $x" }
        return x - columnStart
    }
}
