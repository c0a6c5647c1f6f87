package dev.lazyz

import java.util.stream.IntStream

/** Does [action] for each number from 0 until [count]: several at a time by the common pool, if there are several. */
internal fun inParallel(count: Int, action: (number: Int) -> Unit) {
    if (count == 1) action(0) else IntStream.range(0, count).parallel().forEach(action)
}
