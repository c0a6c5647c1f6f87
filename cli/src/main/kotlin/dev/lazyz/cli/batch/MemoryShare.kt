package dev.lazyz.cli.batch

import java.util.ArrayDeque
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

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
