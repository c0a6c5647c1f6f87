package dev.lazyz.conformance.mutants

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Correct, without capabilities. */
open class PlainRenderer(override val id: String = "plain") : Renderer {
    override val summary: String get() = "a z-buffer that promises nothing"

    override val capabilities: Set<Capability> get() = emptySet()

    override fun render(frame: Frame, sink: RowSink): Counters = ZBufferRenderer().render(frame, sink)
}

/** Inverts the red component at the first sample of each row. */
class WrongColors : PlainRenderer("wrong-colors") {
    override fun render(frame: Frame, sink: RowSink): Counters = super.render(frame) { y, argb, depth, primitive ->
        argb[0] = argb[0] xor 0x00FF0000
        sink.row(y, argb, depth, primitive)
    }
}

/** Throws if there are primitives. */
class Throwing : PlainRenderer("throwing") {
    override fun render(frame: Frame, sink: RowSink): Counters {
        check(frame.primitives.isEmpty()) { "no <primitives> & no \"wonder\"\u0001" }
        return super.render(frame, sink)
    }
}

/** Declares all capabilities, in reverse order. */
class Promising : PlainRenderer("promising") {
    override val capabilities: Set<Capability> get() = Capability.entries.reversed().toSet()
}
