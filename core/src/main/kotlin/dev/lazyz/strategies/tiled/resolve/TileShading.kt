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
