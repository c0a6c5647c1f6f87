package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.strategies.zbuffer.ZBuffer

/** Right, without promises. */
open class PlainRenderer(override val id: String = "plain") : Renderer {
    override val summary: String get() = "a z-buffer that promises nothing"

    override val capabilities: Set<Capability> get() = emptySet()

    override fun render(frame: Frame, sink: RowSink): Counters = ZBuffer().render(frame, sink)
}

/** Turns red to its opposite at the first sample of each row. */
class WrongColors : PlainRenderer("wrong-colors") {
    override fun render(frame: Frame, sink: RowSink): Counters = super.render(frame) { y, argb, depth, primitive ->
        argb[0] = argb[0] xor 0x00FF0000
        sink.row(y, argb, depth, primitive)
    }
}

/** Throws where there is something to draw. */
class Throwing : PlainRenderer("throwing") {
    override fun render(frame: Frame, sink: RowSink): Counters {
        check(frame.primitives.isEmpty()) { "no <primitives> & no \"wonder\"\u0001" }
        return super.render(frame, sink)
    }
}

/** Says that it has all capabilities, the last first. */
class Promising : PlainRenderer("promising") {
    override val capabilities: Set<Capability> get() = Capability.entries.reversed().toSet()
}
