package dev.lazyz.strategies.tiled

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RowSink
import dev.lazyz.strategies.tiled.binning.ArrayPool
import dev.lazyz.strategies.tiled.binning.Arrivals
import dev.lazyz.strategies.tiled.binning.Band
import dev.lazyz.strategies.tiled.binning.TriangleBins
import dev.lazyz.strategies.tiled.raster.Checkpoint
import dev.lazyz.strategies.tiled.raster.TileGrid

/**
 * One rendering, from the first band to the last: the calling thread fills bins, hands rows out, and renders tiles
 * while there is nothing to hand out; the other threads render tiles.
 *
 * There are as many bands at a time as keep all threads at work while one of them is handed out. Used once.
 */
internal class Rendering(
    private val frame: Frame,
    private val grid: TileGrid,
    private val coherence: Coherence,
    private val threads: Int,
    private val kernels: Kernels,
    private val pool: ArrayPool,
) {
    private val columns = grid.columns.toLong()

    /** Number of threads, the caller's included. */
    private val crew = minOf(threads.toLong(), columns * grid.bands).toInt()
    private val schedule = Schedule(grid.columns, crew)
    private val arrivals = Arrivals(frame, grid)

    /** The bands at work: number b is in place b modulo their number. */
    private val bands = Array(bandsAtWork()) { Band(frame, grid, pool) }
    private var filled = 0

    private val test = frame.raster.depthTest
    private val hasBatches = frame.content.batches.isNotEmpty()
    private val bandsAtOnce = TriangleBins.bandsAtOnce(grid)
    private var bins: TriangleBins? = null
    private var binBytes = 0L

    /** One for each thread, the caller's first. */
    private val renderers = List(crew) { number ->
        TileRenderer(frame, grid, coherence, kernels, if (number == 0) Checkpoint(::passCaller) else schedule)
    }

    /** Renders all, and hands every row to [sink]. */
    fun run(sink: RowSink): Counters {
        val workers = ArrayList<Thread>()
        try {
            for (number in 1 until crew) {
                val worker = Thread({ work(number) }, "lazyz-tiled-$number")
                worker.isDaemon = true
                worker.start()
                workers += worker
            }
            lead(sink)
        } catch (e: Throwable) {
            // Somebody else may have failed before: then the interruption is still to be noticed
            schedule.fail(e)
            if (e is InterruptedException && schedule.firstFailure !== e) Thread.currentThread().interrupt()
        } finally {
            schedule.end()
            endAll(workers)
        }
        schedule.firstFailure?.let { throw it }
        for (band in bands) band.release()
        return counters()
    }

    /** The calling thread's part. */
    private fun lead(sink: RowSink) {
        repeat(bands.size) { fillNext() }
        for (number in 0 until grid.bands) {
            // Render tiles, of this band or the next, until this one is complete
            val band = bandAt(number)
            while (!band.isComplete) {
                val tile = schedule.take(0)
                if (tile != Schedule.NONE) render(tile, renderers[0]) else schedule.awaitUntil { band.isComplete }
                passCaller()
            }

            // Hand it out, and use its place for another one
            band.sendTo(sink) { passCaller() }
            band.bins?.finishBand()
            fillNext()
        }
    }

    /** The part of every other thread. */
    private fun work(number: Int) {
        try {
            while (true) {
                val tile = schedule.takeOrWait(number)
                if (tile == Schedule.NONE) return
                render(tile, renderers[number])
            }
        } catch (e: Throwable) {
            schedule.fail(e)
        }
    }

    private fun render(tile: Long, renderer: TileRenderer) {
        val band = bandAt((tile / columns).toInt())
        renderer.render(band, (tile % columns).toInt())
        if (band.finishTile()) schedule.signal()
    }

    /** Fills the bins of the next band, if there is one, and lets its tiles be taken. */
    private fun fillNext() {
        if (filled == grid.bands) return
        arrivals.moveTo(filled)
        if (hasBatches && filled % bandsAtOnce == 0) {
            val until = minOf(filled + bandsAtOnce, grid.bands)
            bins = TriangleBins(frame.content, grid, test, filled, until, threads, kernels::coverage, pool)
                .also { binBytes = maxOf(binBytes, it.bytes) }
        }
        bandAt(filled).fill(filled, arrivals, bins)
        filled++
        schedule.release(filled)
    }

    private fun bandAt(number: Int): Band = bands[number % bands.size]

    /** The calling thread is the one that can be interrupted from outside. */
    private fun passCaller() {
        if (Thread.interrupted()) throw InterruptedException("interrupted while rendering")
        schedule.pass()
    }

    /** Waits until all threads have ended; those that are asleep in somebody else's code are woken up. */
    private fun endAll(workers: List<Thread>) {
        if (schedule.firstFailure != null) for (worker in workers) worker.interrupt()
        var isInterrupted = false
        for (worker in workers) {
            while (worker.isAlive) {
                try {
                    worker.join()
                } catch (_: InterruptedException) {
                    isInterrupted = true
                }
            }
        }
        if (isInterrupted) Thread.currentThread().interrupt()
    }

    private fun counters(): Counters {
        var sum = Counters()
        for (renderer in renderers) sum = sum.plus(renderer.counters)
        sum.primitives = frame.content.size.toLong()

        // As if all parts were at their largest at the same time
        sum.peakBytes = arrivals.bytes + 2 * binBytes + bands.sumOf { it.bytes } + renderers.sumOf { it.bytes }
        return sum
    }

    /** One band for one thread; for more, besides the one that is handed out, enough for two tiles a thread. */
    private fun bandsAtWork(): Int {
        val ahead = if (crew == 1) 0 else (2L * crew - 1) / columns + 1
        return minOf(1 + ahead, grid.bands.toLong()).toInt()
    }
}
