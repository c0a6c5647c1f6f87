package dev.lazyz.conformance.strangers3

import java.util.concurrent.atomic.AtomicReference

/** Threads that share the tiles of a band; each has a stretch of its own and steals from the others when it is done. */
internal class Crew(
    private val threads: Int,
    private val mistake: Mistake?,
    private val work: (worker: Int, tile: Int) -> Unit,
) {
    @Suppress("PLATFORM_CLASS_MAPPED_TO_KOTLIN")
    private val lock = Object()
    private val next = IntArray(threads)
    private val ends = IntArray(threads)
    private var round = 0
    private var open = 0
    private var isOver = false
    private val failure = AtomicReference<Throwable?>()
    private val helpers = ArrayList<Thread>()

    /** Whether to go on. */
    val isStopped: Boolean get() = failure.get() != null

    fun start() {
        for (worker in 1 until threads) {
            val thread = Thread({ help(worker) }, "third-$worker")
            thread.isDaemon = true
            helpers += thread
            thread.start()
        }
    }

    /** Works on tiles 0 until [tiles] together with the helpers; throws what went wrong. */
    fun run(tiles: Int) {
        synchronized(lock) {
            for (worker in 0 until threads) {
                next[worker] = (tiles.toLong() * worker / threads).toInt()
                ends[worker] = (tiles.toLong() * (worker + 1) / threads).toInt()
            }
            open = tiles
            round++
            lock.notifyAll()
        }
        attempt { takeAll(0) }
        attempt { synchronized(lock) { while (open > 0 && !isStopped) await() } }
        failure.get()?.let { throw it }
    }

    private fun await() {
        if (mistake != Mistake.TILES_INTERRUPT_LOST) return lock.wait()
        try {
            lock.wait()
        } catch (_: InterruptedException) {
            // Go on: the band is not complete
        }
    }

    private fun takeAll(worker: Int) {
        while (!isStopped) {
            val tile = take(worker)
            if (tile < 0) return
            if (worker == 0 && Thread.interrupted() && mistake != Mistake.TILES_INTERRUPT_LOST) {
                throw InterruptedException("interrupted")
            }
            try {
                work(worker, tile)
            } finally {
                synchronized(lock) {
                    open--
                    lock.notifyAll()
                }
            }
        }
    }

    private fun take(worker: Int): Int = synchronized(lock) {
        for (i in 0 until threads) {
            val from = (worker + i) % threads
            if (next[from] < ends[from]) return next[from]++
        }
        return -1
    }

    private fun attempt(task: () -> Unit) {
        try {
            task()
        } catch (e: Throwable) {
            failure.compareAndSet(null, e)
            synchronized(lock) { lock.notifyAll() }
        }
    }

    private fun help(worker: Int) {
        try {
            helpOn(worker)
        } catch (_: InterruptedException) {
            // It is to end
        }
    }

    private fun helpOn(worker: Int) {
        var seen = 0
        while (true) {
            synchronized(lock) {
                while (round == seen && !isOver && !isStopped) lock.wait()
                seen = round
            }
            if (isOver || isStopped) return
            when (mistake) {
                Mistake.TILES_ERROR_LOST -> attempt { quietly { takeAll(worker) } }
                Mistake.TILES_HELPER_WRAPS -> attempt { wrapped { takeAll(worker) } }
                else -> attempt { takeAll(worker) }
            }
        }
    }

    private fun quietly(task: () -> Unit) {
        try {
            task()
        } catch (e: Error) {
            if (e is VirtualMachineError) throw e
        }
    }

    private fun wrapped(task: () -> Unit) {
        try {
            task()
        } catch (e: Throwable) {
            throw IllegalStateException("tile failed", e)
        }
    }

    /** Ends the helpers and waits for them. */
    fun close() {
        synchronized(lock) {
            isOver = true
            lock.notifyAll()
        }
        if (isStopped) helpers.forEach { it.interrupt() }
        var isInterrupted = false
        for (helper in helpers) {
            while (helper.isAlive) {
                try {
                    helper.join()
                } catch (_: InterruptedException) {
                    isInterrupted = true
                }
            }
        }
        if (isInterrupted) Thread.currentThread().interrupt()
    }
}
