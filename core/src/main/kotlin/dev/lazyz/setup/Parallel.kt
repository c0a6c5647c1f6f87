package dev.lazyz.setup

import java.util.concurrent.atomic.AtomicReference
import java.util.stream.IntStream

/**
 * Does [action] for each number below [count], on several threads. Memory that runs out in one of them ends the others, and
 * is told to the caller by hand: the pool needs memory to hand an error on, and where it finds none its caller waits for ever.
 */
internal fun inParallel(count: Int, action: (Int) -> Unit) {
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
