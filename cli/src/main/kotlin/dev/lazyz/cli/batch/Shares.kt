package dev.lazyz.cli.batch

import dev.lazyz.cli.output.Progress
import dev.lazyz.scenes.outputs.ContactSheet
import java.util.ArrayDeque
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** What the inputs of a batch share. */
internal class Shares(
    val memory: MemoryShare,
    val threads: ThreadShare,
    val progress: Progress,
    val sheet: ContactSheet?,
)

/**
 * Shares [total] bytes of memory among the inputs that are rendered at the same time. Who asks first is served first,
 * so that a large input is not overtaken without end by small ones. Thread safe.
 */
internal class MemoryShare(val total: Long) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val waiting = ArrayDeque<Any>()
    private var held = 0L

    /**
     * Waits until [bytes] bytes are free, and calls [use] while it holds them. More than [total] means all: then
     * nobody else holds any.
     */
    fun <T> hold(bytes: Long, use: () -> T): T {
        val own = bytes.coerceIn(0, total)
        take(own)
        try {
            return use()
        } finally {
            lock.withLock {
                held -= own
                changed.signalAll()
            }
        }
    }

    private fun take(bytes: Long) {
        val ticket = Any()
        lock.withLock {
            waiting.add(ticket)
            try {
                while (waiting.peek() !== ticket || held + bytes > total) changed.await()
                held += bytes
            } finally {
                waiting.remove(ticket)
                changed.signalAll()
            }
        }
    }
}

/**
 * Shares [total] threads among the inputs that are rendered at the same time: one for each input, and those that are
 * left for the pictures that begin next. Thread safe.
 */
internal class ThreadShare(private val total: Int) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var free = total
    private var inputs = 0

    /** Waits for a thread, and calls [work] while it holds it. */
    fun <T> forInput(work: () -> T): T {
        lock.withLock {
            while (free == 0) changed.await()
            free--
            inputs++
        }
        try {
            return work()
        } finally {
            lock.withLock {
                inputs--
                giveBack(1)
            }
        }
    }

    /** Calls [work] with the number of threads for a picture, at least the one that the input holds. */
    fun <T> forPicture(work: (Int) -> T): T {
        val more = lock.withLock {
            // The others can take the same part when they begin a picture
            ((free + inputs - 1) / inputs).also { free -= it }
        }
        try {
            return work(1 + more)
        } finally {
            lock.withLock { giveBack(more) }
        }
    }

    private fun giveBack(threads: Int) {
        free += threads
        check(free <= total) { "more threads were given back than taken" }
        changed.signalAll()
    }
}
