package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.emit
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.tiled.TiledRenderer

/** Renderers that keep their promises only for opaque primitives, whole pictures or without a selector. */
internal object VariantMistakes {
    private val streaming = setOf(Capability.STREAMS_ROWS, Capability.CONSTANT_MEMORY, Capability.TRANSPARENCY)
    private val parallel = setOf(Capability.PARALLEL, Capability.TRANSPARENCY)

    val mistakes: List<Mistake> = listOf(
        Mistake(::blendsThreeHundred, "blends at most 300 translucent primitives"),
        Mistake(::buffersGlass, "delivers the first row of a translucent picture after the last is rendered"),
        Mistake(::oneThreadForGlass, "one thread for translucent pictures"),
        Mistake(::oneThreadTooManyForGlass, "one thread more than allowed for translucent pictures"),
    )

    fun blendsThreeHundred() = BrokenRenderer("blends-three-hundred", setOf(Capability.TRANSPARENCY)) { frame, sink ->
        val kept = frame.primitives.indices.filter { frame.primitives[it].isTranslucent }.drop(300).toSet()
        ListsRenderer().render(frame.keeping { it !in kept }, sink)
    }

    fun buffersGlass() = BrokenRenderer("buffers-glass", streaming) { frame, sink ->
        if (frame.hasTranslucency) emit(ListsRenderer().render(frame), sink) else ListsRenderer().render(frame, sink)
    }

    fun oneThreadForGlass() = withThreads("one-thread-for-glass", 1) { _, _ -> 1 }

    fun oneThreadTooManyForGlass() = withThreads("one-thread-too-many-for-glass", 1) { threads, _ -> threads + 1 }

    private fun withThreads(id: String, threads: Int, ofGlass: (Int, Frame) -> Int): BrokenRenderer =
        BrokenRenderer(id, parallel, { withThreads(id, it.threads, ofGlass) }) { frame, sink ->
            val all = if (frame.hasTranslucency) ofGlass(threads, frame) else threads
            TiledRenderer(RenderOptions(threads = all, tileSize = 8)).render(frame, sink)
        }
}

/** Renderers that are correct as long as only one setting differs from its default. */
internal object CombinationMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::noBlendingInRegions, "nothing is blended if the region is a part of the raster"),
        Mistake(::noBlendingWithThreads, "nothing is blended with several threads"),
    )

    fun noBlendingInRegions() = glazier("no-blending-in-regions") { frame, _ -> frame.region != frame.raster.region }

    fun noBlendingWithThreads() = glazier("no-blending-with-threads") { _, options -> options.threads > 1 }

    /** Treats glass as opaque when [isLost]. */
    private fun glazier(id: String, isLost: (Frame, RenderOptions) -> Boolean): BrokenRenderer {
        fun configured(options: RenderOptions): BrokenRenderer =
            BrokenRenderer(id, setOf(Capability.TRANSPARENCY), options = { configured(it) }) { frame, sink ->
                ListsRenderer().render(if (isLost(frame, options)) frame.asOpaque() else frame, sink)
            }
        return configured(RenderOptions(threads = 1))
    }
}
