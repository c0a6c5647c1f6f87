package dev.lazyz.conformance.strangers4

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import java.lang.ref.WeakReference
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference

/**
 * Tiles on several threads: primitives go into bins, a tile has a depth buffer of its own and is shaded when it is
 * decided; what is translucent is sorted by sample. The whole region is kept, and handed out at the end.
 */
internal class TileStranger(
    private val mistake: Mistake? = null,
    private val options: RenderOptions = RenderOptions(),
) : Renderer {
    private val kept = AtomicReference<KeptBins>()

    override val id: String get() = "stranger-tile"
    override val summary: String get() = "tiles on several threads, each with a depth buffer, shaded when it is decided"
    override val capabilities: Set<Capability>
        get() = setOf(Capability.PARALLEL, Capability.SHADES_ONLY_VISIBLE, Capability.TRANSPARENCY)

    override fun configured(options: RenderOptions): Renderer = TileStranger(mistake, options.requireSupportedBy(this))

    override fun render(frame: Frame, sink: RowSink): Counters {
        val picture = TilePicture(frame.region)
        val grid = TileGrid(frame.region, options.tileSize)
        val bins = bins(frame, grid)
        if (mistake == Mistake.TILE_NOTHING_TO_DO && frame.primitives.isEmpty()) return Counters.NONE
        val counters = TileCrew(frame, grid, bins, picture, mistake).run(minOf(options.threads, grid.count)).toBuilder()
        counters.primitives = frame.primitives.size.toLong()
        counters.peakBytes += picture.bytes + bins.bytes + 12L * frame.width
        handOut(frame, picture, sink)
        return counters.build()
    }

    private fun bins(frame: Frame, grid: TileGrid): TileBins {
        if (mistake != Mistake.TILE_BINS_KEPT) return TileBins(frame, grid, mistake)

        // The parts of a picture are rendered one after the other: keep the bins
        val last = kept.get()
        if (last != null && last.primitives.get() === frame.primitives && last.columns == grid.columns &&
            last.count == grid.count
        ) {
            return last.bins
        }
        val bins = TileBins(frame, grid, mistake)
        kept.set(KeptBins(WeakReference(frame.primitives), grid.columns, grid.count, bins))
        return bins
    }

    private fun handOut(frame: Frame, picture: TilePicture, sink: RowSink) {
        val test = frame.raster.depthTest
        val argb = IntArray(frame.width)
        val depths = IntArray(frame.width)
        val indices = IntArray(frame.width)
        for (row in 0 until frame.height) {
            picture.argb.copyInto(argb, 0, row * frame.width, (row + 1) * frame.width)
            for (i in 0 until frame.width) {
                depths[i] = test.depthOf(picture.keys[row * frame.width + i])
                indices[i] = test.indexOf(picture.keys[row * frame.width + i])
            }
            sink.row(frame.region.rowStart + row, argb, depths, indices)
        }
    }

    override fun toString(): String = "TileStranger($mistake)"

    private class KeptBins(
        val primitives: WeakReference<List<Primitive>>,
        val columns: Int,
        val count: Int,
        val bins: TileBins,
    )
}

/** The threads of one rendering, of which the caller's is one. */
internal class TileCrew(
    private val frame: Frame,
    private val grid: TileGrid,
    private val bins: TileBins,
    private val picture: TilePicture,
    private val mistake: Mistake?,
) {
    private val next = AtomicInteger()
    private val failure = AtomicReference<Throwable>()
    private val shared = Fragment()

    /** Renders all tiles on [threads] threads. */
    fun run(threads: Int): Counters {
        val helperCount = if (mistake == Mistake.TILE_ONE_THREAD_MORE) threads else threads - 1
        val results = arrayOfNulls<Counters>(helperCount + 1)
        val helpers = ArrayList<Thread>()
        try {
            for (number in 1..helperCount) {
                val helper = Thread({ work(number, results) }, "stranger-tile-$number")
                helper.isDaemon = true
                helper.start()
                helpers += helper
            }
        } catch (e: Throwable) {
            failure.compareAndSet(null, e)
        }
        work(0, results)
        if (mistake == Mistake.TILE_LEAVES_HELPERS) failure.get()?.let { throw it }
        join(helpers)
        failure.get()?.let { throw if (mistake == Mistake.TILE_FAILURE_WRAPPED) IllegalStateException(it) else it }
        val sum = results.filterNotNull().fold(Counters.Builder()) { all, one -> all.add(one) }
        sum.peakBytes = results.filterNotNull().sumOf { it.peakBytes }
        return sum.build()
    }

    private fun work(number: Int, results: Array<Counters?>) {
        try {
            val fragment = if (mistake == Mistake.TILE_SHARED_FRAGMENT) shared else Fragment()
            val worker = TileWorker(frame, grid, bins, picture, fragment, mistake)
            while (failure.get() == null) {
                val tile = next.getAndIncrement()
                if (tile >= grid.count) break
                worker.render(tile)
            }
            results[number] = worker.counters.build()
        } catch (e: Throwable) {
            if (mistake == Mistake.TILE_ERROR_ESCAPES && e !is Exception) throw e
            failure.compareAndSet(null, e)
        }
    }

    /** Waits for the [helpers], whoever interrupts; the picture becomes whole. */
    private fun join(helpers: List<Thread>) {
        var isInterrupted = false
        for (helper in helpers) {
            while (true) {
                try {
                    helper.join()
                    break
                } catch (_: InterruptedException) {
                    isInterrupted = true
                }
            }
        }
        if (isInterrupted && mistake != Mistake.TILE_INTERRUPT_LOST) Thread.currentThread().interrupt()
    }
}
