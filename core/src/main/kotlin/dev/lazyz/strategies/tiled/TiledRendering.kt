package dev.lazyz.strategies.tiled

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Helpers
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.RowSink
import dev.lazyz.Workers
import dev.lazyz.endIfInterrupted
import dev.lazyz.strategies.tiled.binning.ActivePrimitives
import dev.lazyz.strategies.tiled.binning.ArrayPool
import dev.lazyz.strategies.tiled.binning.Band
import dev.lazyz.strategies.tiled.binning.TriangleBins
import dev.lazyz.strategies.tiled.raster.TileGrid
import java.util.concurrent.atomic.AtomicLongArray
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.Condition
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * One rendering, from the first band to the last. The calling thread fills bins, passes rows to the sink, and renders
 * tiles while there are no rows to pass on; the other threads render tiles.
 *
 * The number of bands in progress is large enough to keep all threads busy while one band is passed to the sink. Used
 * once.
 */
internal class TiledRendering(
    private val frame: Frame,
    private val grid: TileGrid,
    private val coherence: Coherence,
    private val workers: Workers,
    private val kernels: Kernels,
    private val pool: ArrayPool,
    private val side: Int,
) {
    private val columns = grid.columns.toLong()

    /** Number of threads, including the calling thread. */
    private val threadCount = minOf(workers.threads.toLong(), columns * grid.bands).toInt()
    private val schedule = Schedule(grid.columns, threadCount)
    private val arrivals = ActivePrimitives(frame, grid)

    /** The bands in progress: band number b is at index b modulo the size of this array. */
    private val bands = Array(bandsAtWork(grid, threadCount)) { Band(frame, grid, pool, side) }
    private var filled = 0

    private val test = frame.raster.depthTest
    private val hasBatches = frame.content.batches.isNotEmpty()
    private val bandsAtOnce = TriangleBins.bandsAtOnce(grid)
    private var bins: TriangleBins? = null
    private var binBytes = 0L

    /** The calling thread is the only one that can be interrupted from outside. */
    private val callerCheckpoint = Checkpoint {
        endIfInterrupted()
        schedule.pass()
    }

    /** One for each thread; the first belongs to the calling thread. */
    private val renderers = List(threadCount) { number ->
        val checkpoint = if (number == 0) callerCheckpoint else schedule
        TileRenderer(frame, grid, coherence, kernels, checkpoint, side)
    }

    /** Renders the frame and passes every row to [sink]. */
    fun run(sink: RowSink): Counters {
        val helpers = Helpers(workers.executor)
        try {
            for (number in 1 until threadCount) helpers.start { runWorker(number) }
            runCallingThread(sink)
        } catch (e: Throwable) {
            // If another thread failed first, its exception is thrown instead of this one: keep the interrupt status
            schedule.fail(e)
            if (e is InterruptedException && schedule.firstFailure !== e) Thread.currentThread().interrupt()
        } finally {
            schedule.end()

            // After a failure, the other threads may be blocked in custom code
            helpers.end(interrupt = schedule.firstFailure != null)
        }
        schedule.firstFailure?.let { throw it }
        for (band in bands) band.release()
        return counters()
    }

    /** The work of the calling thread. */
    private fun runCallingThread(sink: RowSink) {
        repeat(bands.size) { fillNext() }
        for (number in 0 until grid.bands) {
            // Render tiles, of this band or later ones, until this band is complete
            val band = bandAt(number)
            while (!band.isComplete) {
                val tile = schedule.take(0)
                if (tile != Schedule.NONE) render(tile, renderers[0]) else schedule.awaitUntil({ band.isComplete })
                callerCheckpoint.pass()
            }

            // Pass the band to the sink, and reuse its memory for another one
            band.sendTo(sink, callerCheckpoint)
            band.bins?.finishBand()
            fillNext()
        }
    }

    /** The work of every other thread. */
    private fun runWorker(number: Int) {
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

    /** Fills the bins of the next band, if there is one, and releases its tiles to the threads. */
    private fun fillNext() {
        if (filled == grid.bands) return
        arrivals.moveTo(filled)
        if (hasBatches && filled % bandsAtOnce == 0) {
            val until = minOf(filled + bandsAtOnce, grid.bands)
            bins = TriangleBins(
                frame.content, grid, test, filled, until, workers, kernels::coverage, pool, Checkpoint.CALLER,
            ).also { binBytes = maxOf(binBytes, it.bytes) }
        }
        bandAt(filled).fill(filled, arrivals, bins)
        filled++
        schedule.release(filled)
    }

    private fun bandAt(number: Int): Band = bands[number % bands.size]

    private fun counters(): Counters {
        val sum = Counters.Builder()
        for (renderer in renderers) sum.add(renderer.counters.build())
        sum.primitives = frame.content.size.toLong()

        // Assumes that all parts have their peaks at the same time
        sum.peakBytes = arrivals.bytes + 2 * binBytes + bands.sumOf { it.bytes } + renderers.sumOf { it.bytes }
        return sum.build()
    }

    companion object {
        /**
         * Returns the number of bands in progress: one for one thread; for several [threads], enough for two tiles a
         * thread besides the band passed to the sink.
         */
        fun bandsAtWork(grid: TileGrid, threads: Int): Int {
            val ahead = if (threads == 1) 0 else (2L * threads - 1) / grid.columns + 1
            return minOf(1 + ahead, grid.bands.toLong()).toInt()
        }
    }
}

/**
 * The state that the threads of a rendering share: which tile is next, and whether to continue.
 *
 * Tiles are numbered band by band. Each thread has a range of columns. It takes the tiles of this range band after
 * band, as soon as each band is filled, so that the rows' memory stays in its cache. A thread whose range has no tiles
 * left takes tiles from the ranges of other threads. Thread safe.
 *
 * Source: Robert D. Blumofe, Charles E. Leiserson, "Scheduling Multithreaded Computations by Work Stealing", Journal of
 * the ACM 46 (1999); here with a counter for each range in place of a queue.
 *
 * @param columns tiles in a band
 * @param threads number of threads
 */
internal class Schedule(private val columns: Int, threads: Int) : Checkpoint {
    private val ranges = minOf(threads, columns)

    /** Number of tiles of each range that have been taken. */
    private val taken = AtomicLongArray(ranges)

    /** Tiles of bands below this one may be taken. */
    @Volatile
    private var filled = 0

    @Volatile
    private var isOver = false
    private val failure = AtomicReference<Throwable>()
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()

    /** The first failure, or null. */
    val firstFailure: Throwable? get() = failure.get()

    /** Allows tiles of the bands before [end] to be taken. */
    fun release(end: Int) {
        filled = end
        signal()
    }

    /** Returns the next tile for thread number [thread], or [NONE] if none is available now. */
    fun take(thread: Int): Long {
        for (i in 0 until ranges) {
            val tile = takeOf((thread + i) % ranges)
            if (tile != NONE) return tile
        }
        return NONE
    }

    private fun takeOf(range: Int): Long {
        val start = start(range)
        val width = start(range + 1) - start
        while (true) {
            val tile = taken.get(range)
            if (tile >= filled * width) return NONE
            if (taken.compareAndSet(range, tile, tile + 1)) return tile / width * columns + start + tile % width
        }
    }

    /** First column of a range. */
    private fun start(range: Int): Long = columns.toLong() * range / ranges

    private fun hasTiles(): Boolean {
        for (range in 0 until ranges) {
            if (taken.get(range) < filled * (start(range + 1) - start(range))) return true
        }
        return false
    }

    /**
     * Returns the next tile for thread number [thread] once it is available, or [NONE] when the rendering is over. For
     * the threads of an executor, whose interrupt status is not ours: it neither ends the wait nor the rendering.
     */
    fun takeOrWait(thread: Int): Long {
        while (!isOver) {
            val tile = take(thread)
            if (tile != NONE) return tile
            awaitUntil(::hasTiles, Condition::awaitUninterruptibly)
        }
        return NONE
    }

    /**
     * Waits until [condition] holds or the rendering is over. Changes of the condition must be signalled. Spins before
     * it sleeps, because a tile takes less time than waking a thread.
     *
     * @param sleep waits for a signal
     * @throws InterruptedException if the thread is interrupted, unless [sleep] is for threads of an executor
     */
    fun awaitUntil(condition: () -> Boolean, sleep: Condition.() -> Unit = Condition::await) {
        for (spin in 0 until SPINS) {
            if (isOver || condition()) return
            Thread.onSpinWait()
        }
        lock.withLock { while (!isOver && !condition()) changed.sleep() }
    }

    /** Makes waiting threads check their conditions again. */
    fun signal() {
        lock.withLock { changed.signalAll() }
    }

    /** Ends the rendering: threads stop waiting, and stop at their next checkpoint. */
    fun end() {
        isOver = true
        signal()
    }

    /** Ends the rendering because of [cause], the first of which reaches the caller. */
    fun fail(cause: Throwable) {
        if (cause !== Abandoned) failure.compareAndSet(null, cause)
        end()
    }

    /** Throws [Abandoned] if the rendering is over. */
    override fun pass() {
        if (isOver) throw Abandoned
    }

    /** Ends the work of a thread whose rendering is over; never leaves this package. */
    private object Abandoned : RuntimeException(null, null, false, false) {
        private fun readResolve(): Any = Abandoned
    }

    companion object {
        /** Number of checks of a condition before sleeping: about 20 microseconds. */
        private const val SPINS = 500

        /** No tile. */
        const val NONE: Long = -1
    }
}
