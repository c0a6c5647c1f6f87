package dev.lazyz.pipeline

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Primitive
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.opaqueNeeded

/**
 * A [Rendering]. Checks what callers may do, and leaves the work to [draw] and [end].
 *
 * @param draw draws the next primitive
 * @param end passes the rows to the sink
 */
internal class GuardedDrawing(
    private val renderer: Renderer,
    private val draw: (primitive: Primitive) -> Unit,
    private val end: (sink: RowSink) -> Counters,
) : Rendering {
    private val isBlending = Capability.TRANSPARENCY in renderer.capabilities
    private var count = 0
    private var hasEnded = false

    override fun add(primitive: Primitive) {
        check(!hasEnded) { "the image has ended: begin a new one" }
        check(count < Int.MAX_VALUE) { "more than 2^31-1 primitives" }

        // If the primitive throws an exception, it may be drawn in part, so that the image cannot be continued
        hasEnded = true
        val isRefused = !isBlending && primitive.isTranslucent
        if (!isRefused) draw(primitive)
        hasEnded = false
        if (isRefused) throw opaqueNeeded(count, renderer)
        count++
    }

    override fun finish(sink: RowSink): Counters {
        check(!hasEnded) { "the image has ended: begin a new one" }
        hasEnded = true
        return end(sink)
    }
}
