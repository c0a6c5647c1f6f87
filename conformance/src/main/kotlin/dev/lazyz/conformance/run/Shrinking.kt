package dev.lazyz.conformance.run

import dev.lazyz.Frame
import java.time.Duration
import java.util.concurrent.atomic.AtomicInteger
import kotlin.streams.asSequence
import net.jqwik.api.Shrinkable
import net.jqwik.api.ShrinkingMode

/** Whether a frame that fails is shrunk. */
internal enum class Shrinking(val mode: ShrinkingMode) {
    /** With a limited number of steps. */
    ON(ShrinkingMode.FULL),

    OFF(ShrinkingMode.OFF),
}

/**
 * Limits the search for a smaller frame on which a rule fails. The search itself is jqwik's, which chooses the frames.
 *
 * @param steps how many frames may be tried, the same ones in every run
 * @param patience how long the search may take
 */
internal class ShrinkingLimit(steps: Int, private val patience: Duration) {
    private val stepsLeft = AtomicInteger(steps)
    private var since = 0L

    /** Begins the search. */
    fun begin() {
        since = System.nanoTime()
    }

    /** Ends the search before the next step. */
    fun end() = stepsLeft.set(0)

    /** Counts [frame], which is rendered in a step, as more steps if it has many primitives. */
    fun count(frame: Frame) {
        stepsLeft.addAndGet(-frame.primitives.size / PRIMITIVES_OF_A_STEP)
    }

    /** Returns whether another step is possible, and counts it. */
    fun isStepLeft(): Boolean = stepsLeft.getAndDecrement() > 0 && System.nanoTime() - since < patience.toNanos()

    private companion object {
        /**
         * Each multiple of this number of primitives counts as one more step, so that shrinking large frames takes
         * fewer steps.
         */
        const val PRIMITIVES_OF_A_STEP = 1000
    }
}

/**
 * Ends jqwik's search for a smaller frame, which would otherwise visit many thousands of candidates even if none is
 * tried. An error, because jqwik treats an exception as another failure.
 */
internal class ShrinkingEnds : Error("shrinking has ended") {
    override fun fillInStackTrace(): Throwable = this
}

/**
 * Searches for a smaller value than [whole], without jqwik's lifecycle of a test.
 *
 * @param first the failure of [whole]
 * @param steps how many values are tried at most
 * @param failure returns how a value fails, or null if it does not
 * @return the smallest value that was found to fail, and its failure
 */
internal fun <T, F : Any> smallest(whole: Shrinkable<T>, first: F, steps: Int, failure: (T) -> F?): Pair<T, F> {
    var best = whole
    var why = first
    var tried = 0
    do {
        val before = best
        for (candidate in best.shrink().asSequence()) {
            if (++tried > steps) break
            why = failure(candidate.value()) ?: continue
            best = candidate
            break
        }
    } while (best !== before && tried <= steps)
    return best.value() to why
}
