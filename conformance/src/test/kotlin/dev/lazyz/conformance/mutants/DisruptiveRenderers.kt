package dev.lazyz.conformance.mutants

import dev.lazyz.Frame
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.util.concurrent.CountDownLatch

/**
 * Renderers that would end a run, or give a different report each time. They are not among the [Mistakes],
 * because they take time.
 */
object DisruptiveRenderers {
    fun sleeps() = whereThereIsSomething("sleeps") { Thread.sleep(Long.MAX_VALUE) }

    /** Ignores interrupts; ends only with the process. */
    fun spins() = whereThereIsSomething("spins") { while (true) Thread.onSpinWait() }

    /** Never ends, but runs a little now and then. */
    fun dozes() = whereThereIsSomething("dozes") { while (true) Thread.sleep(5) }

    /** Waits for its own thread, which never signals. */
    fun waits() = whereThereIsSomething("waits") {
        val never = CountDownLatch(1)
        Thread({ never.await() }, "never-done").apply { isDaemon = true }.start()
        never.await()
    }

    /** Ends the process without a message. */
    fun halts() = whereThereIsSomething("halts") { Runtime.getRuntime().halt(7) }

    /** Never returns. */
    fun never(): Nothing {
        while (true) Thread.sleep(Long.MAX_VALUE)
    }

    fun exhausts() = whereThereIsSomething("exhausts") { List(8) { LongArray(Int.MAX_VALUE) } }

    fun recurses() = whereThereIsSomething("recurses") { depthOf(0) }

    fun forgets() = whereThereIsSomething("forgets") { TODO("to be written") }

    @Suppress("removal", "DEPRECATION")
    fun dies() = whereThereIsSomething("dies") { throw ThreadDeath() }

    /** Wrong once in ten times. */
    fun racy(): BrokenRenderer {
        var calls = 0
        return BrokenRenderer("racy") { frame, sink ->
            if (++calls % 10 == 0) WrongColors().render(frame, sink) else ZBufferRenderer().render(frame, sink)
        }
    }

    /** Wrong if the previous frame was wide. */
    fun stateful(): BrokenRenderer {
        var lastWidth = 0
        return BrokenRenderer("stateful") { frame, sink ->
            val isWrong = lastWidth > frame.width * 4
            lastWidth = frame.width
            if (isWrong) WrongColors().render(frame, sink) else ZBufferRenderer().render(frame, sink)
        }
    }

    private fun depthOf(depth: Int): Int = 1 + depthOf(depth + 1)

    private fun whereThereIsSomething(id: String, block: (Frame) -> Any?) = BrokenRenderer(id) { frame, sink ->
        if (frame.primitives.size > 2) block(frame)
        ZBufferRenderer().render(frame, sink)
    }
}
