package dev.lazyz.conformance.strangers5

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RowSink

/** The threads of one rendering, and the bands that are finished but not handed out. */
internal class DeferredCrew(
    private val frame: Frame,
    private val bands: DeferredBands,
    threads: Int,
    private val mistake: Mistake?,
) {
    @Suppress("PLATFORM_CLASS_MAPPED_TO_KOTLIN") // For wait and notifyAll
    private val lock = Object()
    private val size = minOf(threads, bands.count)
    private val window = 2 * size
    private val finished = HashMap<Int, DeferredResult>()
    private val common = Counters.Builder()
    private val argb = IntArray(frame.width)
    private val depths = IntArray(frame.width)
    private val indices = IntArray(frame.width)
    private var next = 0
    private var handedOut = 0
    private var failure: Throwable? = null
    private val counters = Counters.Builder()
    private var listBytes = 0L
    private var wasEmpty = false

    @Volatile
    private var isStopped = false

    /** Renders, and hands out all rows. */
    fun run(sink: RowSink): Counters {
        counters.primitives = frame.primitives.size.toLong()
        val helpers = List(size - 1) { Thread({ help() }, "deferred5-$it").apply { isDaemon = true } }
        try {
            helpers.forEach { it.start() }
            work(sink)
        } catch (e: Throwable) {
            stop(e)
        } finally {
            stop(null)
            if (failure == null || mistake != Mistake.DEFERRED_LEAVES_EARLY) join(helpers)
        }
        failure?.let { throw it }
        counters.add(common.build())
        if (mistake == Mistake.DEFERRED_SUSPENSIONS) counters.peakSuspensions *= size
        counters.peakBytes = bands.bytes + 12L * frame.width + listBytes * size +
            frame.width.toLong() * bands.height * (12L * window + 20L * size)
        return counters.build()
    }

    private fun join(helpers: List<Thread>) {
        var wasInterrupted = false
        for (helper in helpers) {
            while (helper.isAlive) {
                try {
                    helper.join()
                } catch (_: InterruptedException) {
                    wasInterrupted = true
                }
            }
        }
        if (wasInterrupted) Thread.currentThread().interrupt()
    }

    private fun stop(cause: Throwable?) = synchronized(lock) {
        if (failure == null) failure = cause
        isStopped = true
        lock.notifyAll()
    }

    /** What the caller does: hands out what is next, or else makes a band, or else waits. */
    private fun work(sink: RowSink) {
        val band = DeferredBand(frame, bands, mistake) { isStopped }
        while (true) {
            if (mistake != Mistake.DEFERRED_DEAF && Thread.interrupted()) throw InterruptedException("interrupted")
            val ready = synchronized(lock) {
                if (failure != null || handedOut == bands.count) return
                finished.remove(handedOut)
            }
            if (ready != null) {
                handOut(ready, sink)
                continue
            }
            val number = claim()
            if (number >= 0) make(band, number) else await()
        }
    }

    private fun await() {
        synchronized(lock) {
            if (isStopped || handedOut == bands.count || finished.containsKey(handedOut) || mayClaim()) return
            try {
                lock.wait()
            } catch (e: InterruptedException) {
                if (mistake != Mistake.DEFERRED_DEAF) throw e
            }
        }
    }

    /** What the other threads do. */
    private fun help() {
        try {
            val band = DeferredBand(frame, bands, mistake) { isStopped }
            while (true) {
                val number = synchronized(lock) {
                    while (!isStopped && next < bands.count && !mayClaim()) lock.wait()
                    if (isStopped || next == bands.count) return
                    next++
                }
                make(band, number)
            }
        } catch (e: Throwable) {
            stop(if (mistake == Mistake.DEFERRED_WRAPPED) IllegalStateException("a worker failed", e) else e)
        }
    }

    private fun mayClaim() = next < bands.count && next < handedOut + window

    private fun claim(): Int = synchronized(lock) { if (mayClaim()) next++ else -1 }

    private fun make(band: DeferredBand, number: Int) {
        val result =
            band.render(number, if (mistake == Mistake.DEFERRED_LOST_COUNTS) common else Counters.Builder()) ?: return
        synchronized(lock) {
            finished[number] = result
            listBytes = maxOf(listBytes, band.listBytes)
            lock.notifyAll()
        }
    }

    private fun handOut(result: DeferredResult, sink: RowSink) {
        val width = frame.width
        for (row in 0 until result.height) {
            val isEmpty = result.isEmpty(row, width)
            if (mistake != Mistake.DEFERRED_EMPTY_ROW || !isEmpty || !wasEmpty) {
                result.argb.copyInto(argb, 0, row * width, (row + 1) * width)
                result.depths.copyInto(depths, 0, row * width, (row + 1) * width)
                result.indices.copyInto(indices, 0, row * width, (row + 1) * width)
            }
            wasEmpty = isEmpty
            sink.row(result.top + row, argb, depths, indices)
        }
        synchronized(lock) {
            if (mistake != Mistake.DEFERRED_LOST_COUNTS) counters.add(result.counters.build())
            handedOut++
            lock.notifyAll()
        }
    }
}

/** A finished band: rows from [top] on. */
internal class DeferredResult(val top: Int, val height: Int, size: Int, val counters: Counters.Builder) {
    val argb = IntArray(size)
    val depths = IntArray(size)
    val indices = IntArray(size)

    /** Whether nothing but background is in a row. */
    fun isEmpty(row: Int, width: Int): Boolean =
        (row * width until (row + 1) * width).none { indices[it] != dev.lazyz.DepthTest.BACKGROUND }
}
