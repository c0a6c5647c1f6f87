package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.zbuffer.ZBuffer

/** Renderers that are correct as long as only one setting differs from its default. */
object BrokenCombinations {
    /** Counts tiles from the raster's corner, although the region begins elsewhere. */
    fun partsInSmallTiles() = BrokenRenderer("parts-in-small-tiles", options = { options ->
        BrokenRenderer("parts-in-small-tiles") { frame, sink ->
            val first = frame.region.columnStart
            val isSplit = options.tileSize < 64 && first % options.tileSize != 0
            val image = ZBuffer().render(frame)
            if (isSplit) for (i in image.argb.indices step image.width) image.primitive[i] = -1
            emit(image, sink)
        }
    }) { frame, sink -> ZBuffer().render(frame, sink) }

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

    /** Leftovers of a failure appear in the next picture, if options were given. */
    fun failureShowsLater() = BrokenRenderer("failure-shows-later", options = {
        var hasFailed = false
        BrokenRenderer("failure-shows-later") { frame, sink ->
            val wasFailing = hasFailed
            hasFailed = true
            val image = ZBuffer().render(frame)
            hasFailed = false
            if (wasFailing) image.depth.fill(0)
            emit(image, sink)
        }
    }) { frame, sink -> ZBuffer().render(frame, sink) }
}
