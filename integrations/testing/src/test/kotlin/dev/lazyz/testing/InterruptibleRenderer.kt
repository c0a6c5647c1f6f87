package dev.lazyz.testing

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink

/** Looks for an interrupt, and does nothing else. */
internal object InterruptibleRenderer : Renderer {
    override val id: String = "interruptible"
    override val summary: String = "looks for an interrupt"

    override fun render(frame: Frame, sink: RowSink): Counters {
        if (Thread.interrupted()) throw InterruptedException()
        return Counters.NONE
    }
}
