package dev.lazyz.conformance.probes

import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.inTime

/**
 * Renders [frames] so that no rendering is completed: a primitive throws, the sink throws, or the thread is
 * interrupted. Each frame has its own deadline.
 */
internal fun failAll(renderer: Renderer, frames: List<Frame>) {
    for (frame in frames) {
        TryUnderWay.current?.goesOn()
        for (way in renderer.ways()) {
            answer { way.inTime(Trap(frame, Question.COLOUR, 0).frame) { _, _, _, _ -> } }
            answer { way.inTime(frame) { _, _, _, _ -> throw Planted.EXCEPTION.make() } }
            Thread.currentThread().interrupt()
            answer { way.inTime(frame) { _, _, _, _ -> } }

            // The renderer may have cleared the status already
            Thread.interrupted()
        }
    }
}
