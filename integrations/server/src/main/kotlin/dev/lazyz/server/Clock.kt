package dev.lazyz.server

import io.netty.util.concurrent.EventExecutor
import java.time.Duration
import java.util.concurrent.Future
import java.util.concurrent.TimeUnit

/** The time limit of a connection, and what it checks from time to time. Used on its event loop, [executor]. */
internal class Clock(private val executor: EventExecutor) {
    private var limit: Future<*>? = null
    private var repetition: Future<*>? = null

    /** Calls [act] after [time], in place of the limit before. */
    fun after(time: Duration, act: () -> Unit) {
        end()
        limit = executor.schedule(act, time.toMillis(), TimeUnit.MILLISECONDS)
    }

    /** Ends the limit. */
    fun end() {
        limit?.cancel(false)
    }

    /** Calls [act] once each [time], in place of the repetition before. */
    fun each(time: Duration, act: () -> Unit) {
        endEach()
        repetition = executor.scheduleAtFixedRate(act, time.toMillis(), time.toMillis(), TimeUnit.MILLISECONDS)
    }

    /** Ends the repetition. */
    fun endEach() {
        repetition?.cancel(false)
    }
}
