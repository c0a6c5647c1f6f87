package dev.lazyz.pipeline

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.shading.LateShading
import java.io.IOException

/**
 * A row of cells, each with a depth and a colour that is computed on demand. The pull renderers return one row at a
 * time.
 *
 * The visible primitive and the depth of every column are known. A colour is computed when it is first requested, and
 * then stored: reading the colour of one column makes one shading call, reading none makes none. Columns are those of
 * the raster, [columnStart] until [columnEnd], the columns of the region.
 *
 * A row owns its cells: it stays valid after the next row is pulled. Thread safe. Memory: 8 bytes a column, and 4 more
 * once colours have been requested.
 *
 * Use [Renderer.render] for whole images. Use rows to stream an image, to stop early, or to read only some samples. Get
 * rows from `LazyRenderer.rows` or `FlowRenderer.rows`. To pull finished rows from any renderer, as plain arrays, use
 * [dev.lazyz.RenderedRows].
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 2. There a cell is a pair
 * of a depth and an unevaluated colour. Here it is one visibility key: the primitive's index and the sample determine
 * the colour (contract rule 6.1).
 *
 * @property y the row of the raster
 */
public class LazyRow internal constructor(
    private val frame: Frame,
    public val y: Int,
    private val coherence: Coherence
) {
    /**
     * The work for this row only: of the renderer to create it, and of later calls to shade it. Added up over all rows
     * with [Counters.plus], they are the counters of the whole rendering. The number of primitives is counted in the
     * first row.
     */
    public val counters: Counters
        @Synchronized
        get() = counting.build()

    internal val counting = Counters.Builder()

    /** The first column of the row. */
    public val columnStart: Int get() = frame.region.columnStart

    /** The column after the last of the row. */
    public val columnEnd: Int get() = frame.region.columnEnd

    /** Number of columns. */
    public val width: Int get() = frame.region.width

    internal val test = frame.raster.depthTest
    private val background = frame.raster.background.toArgb()

    /**
     * The keys of the cells, from [columnStart] on. Stages lower them while the row passes through the chain; after
     * that, they do not change.
     */
    internal val keys = LongArray(width)

    /** Bytes of the renderer and of this row. */
    private var bytes = keys.bytes

    /** The colours computed so far. */
    private var colors: IntArray? = null

    /** The columns whose colour has been computed, one bit for each; null if there are none, or if all have been. */
    private var forced: LongArray? = null
    private var isWhole = false

    /** Computes the colours of single columns. */
    private var single: LateShading? = null

    init {
        keys.fill(test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND))
    }

    /**
     * Returns the depth at column [x], 0..2^31-1, see [Depth]. No shading calls.
     *
     * @throws IllegalArgumentException if [x] is not in the row
     */
    public fun depth(x: Int): Int = test.depthOf(keys[at(x)])

    /**
     * Returns the submission index of the primitive visible at column [x], or [DepthTest.BACKGROUND]. No shading calls.
     *
     * @throws IllegalArgumentException if [x] is not in the row
     */
    public fun primitive(x: Int): Int = test.indexOf(keys[at(x)])

    /**
     * Returns the colour at column [x], `0xAARRGGBB`. Cost: one shading call if it is the first request and a primitive
     * is visible there. The attributes are evaluated directly, whatever the [Coherence].
     *
     * @throws IllegalArgumentException if [x] is not in the row
     */
    @Synchronized
    public fun argb(x: Int): Int {
        val at = at(x)
        val colors = colors()
        if (isWhole) return colors[at]

        // Compute the colour unless it is known
        val forced = forced()
        if (!isForced(forced, at)) {
            val shading = single ?: LateShading(frame, Coherence.DIRECT, counting, Checkpoint.NONE).also { single = it }
            colors[at] = color(at, shading)
            forced[at / Long.SIZE_BITS] = forced[at / Long.SIZE_BITS] or (1L shl at)
        }
        return colors[at]
    }

    /**
     * Returns all colours, `0xAARRGGBB`, from [columnStart] on. Cost: one shading call for each visible sample that has
     * not been shaded yet, from left to right, with the renderer's [Coherence]. The array is not copied and must not be
     * changed.
     */
    public fun argb(): IntArray = argb(Checkpoint.NONE)

    @Synchronized
    private fun argb(checkpoint: Checkpoint): IntArray {
        val colors = colors()
        if (isWhole) return colors
        val shading = LateShading(frame, coherence, counting, checkpoint)
        val forced = forced
        for (i in 0 until width) if (forced == null || !isForced(forced, i)) colors[i] = color(i, shading)
        account(shading.peakBytes)

        // All colours are known now
        isWhole = true
        single = null
        bytes -= forced?.bytes ?: 0
        this.forced = null
        return colors
    }

    /**
     * Computes all colours and passes this row to [sink]. The sink must not change the array of colours.
     *
     * @throws IOException if the sink throws it
     */
    @Throws(IOException::class)
    public fun sendTo(sink: RowSink) {
        sendTo(sink, Checkpoint.NONE)
    }

    /** As the other [sendTo]. Passes [checkpoint] for each colour. */
    internal fun sendTo(sink: RowSink, checkpoint: Checkpoint) {
        val colors = argb(checkpoint)
        val depths = IntArray(width)
        val indices = IntArray(width)
        test.decode(keys, 0, depths, indices)
        account(depths.bytes + indices.bytes)
        sink.row(y, colors, depths, indices)
    }

    override fun toString(): String = "LazyRow($y, columns $columnStart..<$columnEnd, $counters)"

    private fun colors(): IntArray = colors ?: IntArray(width).also {
        colors = it
        hold(it.bytes)
    }

    private fun forced(): LongArray = forced ?: LongArray((width + Long.SIZE_BITS - 1) / Long.SIZE_BITS).also {
        forced = it
        hold(it.bytes)
    }

    private fun isForced(forced: LongArray, at: Int): Boolean = forced[at / Long.SIZE_BITS] ushr at and 1L != 0L

    private fun color(at: Int, shading: LateShading): Int {
        val index = test.indexOf(keys[at])
        return if (index == DepthTest.BACKGROUND) background else shading.shade(columnStart + at, y, index)
    }

    /** Adds [more] bytes, which stay in use, to the memory counter. */
    internal fun hold(more: Long) {
        bytes += more
        account(0)
    }

    /** Updates the memory counter with [passing] bytes, in temporary use in addition to those that stay. */
    @Synchronized
    private fun account(passing: Long) {
        counting.peakBytes = maxOf(counting.peakBytes, bytes + passing)
    }

    private fun at(x: Int): Int {
        require(x in columnStart until columnEnd) { "column must be in $columnStart..<$columnEnd: $x" }
        return x - columnStart
    }
}
