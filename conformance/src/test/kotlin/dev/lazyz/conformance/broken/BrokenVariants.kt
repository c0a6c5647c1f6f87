package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.tiled.Tiled

/** Renderers that keep their promises only for opaque primitives, whole pictures or without a selector. */
internal object BrokenVariants {
    private val streaming = setOf(Capability.STREAMS_ROWS, Capability.CONSTANT_MEMORY, Capability.TRANSPARENCY)

    fun cutsColumnsOfGlass() = BrokenRenderer("cuts-columns-of-glass", setOf(Capability.TRANSPARENCY)) { frame, sink ->
        val primitives = frame.primitives.map { if (it.isTranslucent) Cut(it) else it }
        Lists().render(Frame(frame.raster, primitives, frame.region), sink)
    }

    private class Cut(private val whole: Primitive) : Primitive by whole {
        override fun shade(fragment: Fragment) {
            val (x, y) = fragment.x to fragment.y
            fragment.moveTo(x and 0xFFFF, y)
            whole.shade(fragment)
            val color = with(fragment) { floatArrayOf(red, green, blue, alpha) }
            fragment.moveTo(x, y)
            fragment.setColor(color[0], color[1], color[2], color[3])
        }
    }

    fun blendsThreeHundred() = BrokenRenderer("blends-three-hundred", setOf(Capability.TRANSPARENCY)) { frame, sink ->
        val kept = frame.primitives.indices.filter { frame.primitives[it].isTranslucent }.drop(300).toSet()
        Lists().render(frame.keeping { it !in kept }, sink)
    }

    fun keepsRowsOfGlass() = BrokenRenderer("keeps-rows-of-glass", streaming) { frame, sink ->
        val kept = ArrayList<IntArray>()
        Lists().render(frame) { y, argb, depth, primitive ->
            if (frame.hasTranslucency) kept.add(argb.copyOf())
            sink.row(y, argb, depth, primitive)
        }
    }

    fun buffersGlass() = BrokenRenderer("buffers-glass", streaming) { frame, sink ->
        if (frame.hasTranslucency) emit(Lists().render(frame), sink) else Lists().render(frame, sink)
    }

    fun shadesAllInARegion() =
        BrokenRenderer("shades-all-in-a-region", setOf(Capability.SHADES_ONLY_VISIBLE)) { frame, sink ->
            val counters = Lists().render(frame, sink)
            val isPart = frame.region != frame.raster.region
            if (isPart) counters.toBuilder().apply { shadingCalls = fragments }.build() else counters
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
