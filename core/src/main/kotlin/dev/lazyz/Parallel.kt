package dev.lazyz

import java.util.concurrent.atomic.AtomicReference
import java.util.stream.IntStream

/**
 * Calls [action] for each number in 0 until [count]. If there are several, the calls run in parallel in the common
 * pool.
 *
 * If memory runs out in one call, the calls that have not started are skipped, and the error is thrown to the caller.
 * It does not go through the pool, because the pool needs memory to pass an error on; without memory its caller waits
 * forever.
 */
internal fun inParallel(count: Int, action: (number: Int) -> Unit) {
    if (count == 1) {
        action(0)
        return
    }
    val exhausted = AtomicReference<OutOfMemoryError>()
    IntStream.range(0, count).parallel().forEach { number ->
        try {
            if (exhausted.get() == null) action(number)
        } catch (e: OutOfMemoryError) {
            exhausted.compareAndSet(null, e)
        }
    }
    exhausted.get()?.let { throw it }
}
