package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.strategies.lists.Lists

/** Renderers that are correct as long as only one setting differs from its default. */
object BrokenCombinations {

    fun noBlendingInRegions() = glazier("no-blending-in-regions") { frame, _ -> frame.region != frame.raster.region }

    fun noBlendingWithThreads() = glazier("no-blending-with-threads") { _, options -> options.threads > 1 }

    /** Treats glass as opaque when [isLost]. */
    private fun glazier(id: String, isLost: (Frame, RenderOptions) -> Boolean): BrokenRenderer {
        fun configured(options: RenderOptions): BrokenRenderer =
            BrokenRenderer(id, setOf(Capability.TRANSPARENCY), options = { configured(it) }) { frame, sink ->
                Lists().render(if (isLost(frame, options)) frame.asOpaque() else frame, sink)
            }
        return configured(RenderOptions(threads = 1))
    }
}
