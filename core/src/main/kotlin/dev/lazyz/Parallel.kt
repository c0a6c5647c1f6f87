package dev.lazyz

import java.util.stream.IntStream

/**
 * Calls [action] for each number in 0 until [count]. If there are several, the calls run in parallel in the common
 * pool.
 */
internal fun inParallel(count: Int, action: (number: Int) -> Unit) {
    if (count == 1) action(0) else IntStream.range(0, count).parallel().forEach(action)
}
