package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.tiled.Tiled

/** Renderers that keep their promises only for opaque primitives, whole pictures or without a selector. */
internal object BrokenVariants {
    private val streaming = setOf(Capability.STREAMS_ROWS, Capability.CONSTANT_MEMORY, Capability.TRANSPARENCY)

    fun blendsThreeHundred() = BrokenRenderer("blends-three-hundred", setOf(Capability.TRANSPARENCY)) { frame, sink ->
        val kept = frame.primitives.indices.filter { frame.primitives[it].isTranslucent }.drop(300).toSet()
        Lists().render(frame.keeping { it !in kept }, sink)
    }

    fun buffersGlass() = BrokenRenderer("buffers-glass", streaming) { frame, sink ->
        if (frame.hasTranslucency) emit(Lists().render(frame), sink) else Lists().render(frame, sink)
    }

    private val parallel = setOf(Capability.PARALLEL, Capability.TRANSPARENCY)

    fun oneThreadForGlass() = withThreads("one-thread-for-glass", 1) { _, _ -> 1 }

    fun oneThreadTooManyForGlass() = withThreads("one-thread-too-many-for-glass", 1) { threads, _ -> threads + 1 }

    private fun withThreads(id: String, threads: Int, ofGlass: (Int, Frame) -> Int): BrokenRenderer =
        BrokenRenderer(id, parallel, { withThreads(id, it.threads, ofGlass) }) { frame, sink ->
            val all = if (frame.hasTranslucency) ofGlass(threads, frame) else threads
            Tiled(RenderOptions(threads = all, tileSize = 8)).render(frame, sink)
        }

    fun wrapsTheSelectors(): BrokenRenderer = wrapsTheSelectors(RenderOptions())

    private fun wrapsTheSelectors(options: RenderOptions): BrokenRenderer =
        BrokenRenderer("wraps-the-selectors", setOf(Capability.SELECTION), { wrapsTheSelectors(it) }) { frame, sink ->
            val inner = options.selector?.let { selector ->
                Selector {
                    try {
                        selector.select(it)
                    } catch (e: RuntimeException) {
                        throw IllegalStateException("the selector failed", e)
                    }
                }
            }
            Lists(options.withSelector(inner)).render(frame, sink)
        }
}
