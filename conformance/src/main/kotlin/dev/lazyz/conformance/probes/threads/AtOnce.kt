package dev.lazyz.conformance.probes.threads

import java.util.concurrent.CyclicBarrier
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors

/** Calls [block] for each of [cases] in a separate thread, all at the same time. Rethrows the first failure. */
internal fun <T> atOnce(cases: List<T>, block: (T) -> Unit) {
    val threads = Executors.newFixedThreadPool(cases.size) { Thread(it).apply { isDaemon = true } }
    try {
        val barrier = CyclicBarrier(cases.size)
        val results = cases.map { case ->
            threads.submit {
                barrier.await()
                block(case)
            }
        }
        for (result in results) result.get()
    } catch (e: ExecutionException) {
        throw e.cause ?: e
    } finally {
        threads.shutdownNow()
    }
}
