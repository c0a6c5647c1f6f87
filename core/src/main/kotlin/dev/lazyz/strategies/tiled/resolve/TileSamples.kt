package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.strategies.tiled.binning.Band
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * Fills in what a tile shows, after the visible primitives are known. Belongs to one thread; reused for each tile.
 *
 * @param side how many samples wide and high a pixel is
 */
internal abstract class TileShading(
    protected val frame: Frame,
    protected val keys: VisibilityBuffer,
    layers: TileLayers,
    coherence: Coherence,
    kernel: FragmentKernel,
    counters: Counters.Builder,
    checkpoint: Checkpoint,
    private val side: Int,
) : FragmentSink {
    protected val test: DepthTest = frame.raster.depthTest
    protected val background: Int = frame.raster.background.toArgb()
    private val firstColumn = frame.region.columnStart

    /** Computes colours, which it passes to this. */
    protected val fragments: FragmentShading =
        FragmentShading(frame, keys, layers, coherence, kernel, counters, checkpoint, this)

    /** The band that the tile belongs to, and where the tile begins in its rows. */
    protected lateinit var band: Band
        private set
    protected var toColumn: Int = 0
        private set

    /** Peak number of bytes held. */
    open val bytes: Long get() = fragments.bytes

    /**
     * Fills in colour, depth and primitive of the tile in [band].
     *
     * @param isFine whether most triangles are probably so small that they have one run only; affects only the speed
     */
    fun shade(band: Band, isFine: Boolean) {
        this.band = band
        toColumn = (keys.columnStart - firstColumn) / side
        fragments.begin(isFine)
        shadeRows()
        fragments.finish()
        finish()
    }

    /** Adds the visible samples to the [fragments]. */
    protected abstract fun shadeRows()

    /** Ends a tile whose fragments are shaded. */
    protected open fun finish() = Unit

    /** Fills a tile with background: the columns [columnStart] until [columnEnd] of samples of [band]. */
    fun clear(band: Band, columnStart: Int, columnEnd: Int) {
        val start = (columnStart - firstColumn) / side
        val end = (columnEnd - firstColumn) / side
        for (row in 0 until band.rows) {
            band.argb[row].fill(background, start, end)
            band.depth[row].fill(frame.raster.backgroundDepth, start, end)
            band.primitive[row].fill(DepthTest.BACKGROUND, start, end)
        }
    }
}

/** Fills in each sample of a tile. */
internal class TileSamples(
    frame: Frame,
    keys: VisibilityBuffer,
    private val layers: TileLayers,
    coherence: Coherence,
    private val kernel: FragmentKernel,
    counters: Counters.Builder,
    checkpoint: Checkpoint,
) : TileShading(frame, keys, layers, coherence, kernel, counters, checkpoint, side = 1) {
    /**
     * Converts the upper half of a key into a depth: all bits set where the greatest depth wins; see
     * [DepthTest.depthOf].
     */
    private val depthTurn = test.depthOf(0)

    override fun shadeRows() {
        for (y in keys.rowStart until keys.rowEnd) {
            fragments.beginRow()
            if (layers.isEmpty) shadeRow(y) else blendRow(y)
        }
    }

    private fun shadeRow(y: Int) {
        val row = y - keys.rowStart
        val all = keys.keys
        val first = keys.place(keys.columnStart, y)
        val width = keys.columnEnd - keys.columnStart
        val depths = band.depth[row]
        for (i in 0 until width) depths[toColumn + i] = (all[first + i] ushr Int.SIZE_BITS).toInt() xor depthTurn
        val indices = band.primitive[row]
        var at = 0
        while (at < width) {
            val end = kernel.runEnd(all, first + at, first + width) - first
            val index = test.indexOf(all[first + at])
            for (i in at until end) indices[toColumn + i] = index
            shadeRun(index, row, at, end)
            at = end
        }
    }

    /** Computes the colours of the columns [from] until [until] of the tile in [row], all of the primitive [index]. */
    private fun shadeRun(index: Int, row: Int, from: Int, until: Int) {
        if (index == DepthTest.BACKGROUND) {
            band.argb[row].fill(background, toColumn + from, toColumn + until)
        } else if (fragments.isOnce(index)) {
            fragments.forEachPart(from, until) { start, end ->
                fragments.addPart(index, PrimitiveRuns.place(row, start), end - start)
            }
        } else {
            fragments.add(index, PrimitiveRuns.place(row, from), until - from)
        }
    }

    private fun blendRow(y: Int) {
        val row = y - keys.rowStart
        for (x in keys.columnStart until keys.columnEnd) {
            val column = x - keys.columnStart
            val opaque = keys.at(x, y)
            val key = layers.nearest(keys.place(x, y), opaque)
            band.depth[row][toColumn + column] = test.depthOf(key)
            band.primitive[row][toColumn + column] = test.indexOf(key)
            if (key == opaque) {
                shadeRun(test.indexOf(key), row, column, column + 1)
            } else {
                band.argb[row][toColumn + column] = fragments.blend(x, y)
            }
        }
    }

    override fun store(fragments: WaitingFragments, argb: IntArray) {
        for (i in 0 until fragments.size) {
            val place = fragments.places[i]
            if (fragments.isMoved) {
                fill(place, fragments.lengths[i], argb[i])
            } else {
                band.argb[PrimitiveRuns.row(place)][toColumn + PrimitiveRuns.column(place)] = argb[i]
            }
        }
    }

    override fun fill(start: Int, length: Int, argb: Int) {
        val column = toColumn + PrimitiveRuns.column(start)
        band.argb[PrimitiveRuns.row(start)].fill(argb, column, column + length)
    }
}
