package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Spans
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.util.Collections
import java.util.IdentityHashMap

/** Renderers that render correctly as long as they are used in the usual way. */
object BrokenManners {
    fun regionOffsetTwice() = BrokenRenderer("region-offset-twice") { frame, sink ->
        ZBuffer().render(frame) { y, argb, depth, primitive ->
            sink.row(y + frame.region.rowStart, argb, depth, primitive)
        }
    }

    /** The options are set in the renderer that is asked for another one. */
    fun configuresItself(): BrokenRenderer {
        var current: Renderer = Lists()
        lateinit var itself: BrokenRenderer
        itself = BrokenRenderer(
            "configures-itself",
            setOf(Capability.SELECTION, Capability.TRANSPARENCY),
            { options -> itself.also { current = Lists(options) } },
        ) { frame, sink -> current.render(frame, sink) }
        return itself
    }

    /** Correct on all frames of the suite. */
    fun widthOf97() = BrokenRenderer("width-of-97") { frame, sink ->
        val renderer = if (frame.raster.width == 97) WrongColors() else ZBuffer()
        renderer.render(frame, sink)
    }

    /** Visits all primitives before it considers the region. */
    fun looksOutsideTheRegion() = BrokenRenderer("looks-outside-the-region") { frame, sink ->
        for (it in frame.primitives) for (y in it.rowStart until it.rowEnd) it.spans(y, Spans())
        ZBuffer().render(frame, sink)
    }

    fun columnsOfTheRaster() = BrokenRenderer("columns-of-the-raster") { frame, sink ->
        val region = frame.region
        val wide = Region(0, region.rowStart, region.columnEnd, region.rowEnd)
        ZBuffer().render(frame.within(wide), sink)
    }

    fun notRestartable(): BrokenRenderer {
        val seen = Collections.synchronizedMap(IdentityHashMap<Frame, Unit>())
        return BrokenRenderer("not-restartable") { frame, sink ->
            val isNew = seen.put(frame, Unit) == null
            ZBuffer().render(if (isNew) frame else Frame(frame.raster, emptyList(), frame.region), sink)
        }
    }

    /**
     * Reuses the last picture if the list of primitives and the size are the same, although regions of one frame share
     * the list.
     */
    fun keepsTheClippedPart(): BrokenRenderer {
        var kept: Pair<Frame, Image>? = null
        return BrokenRenderer("keeps-the-clipped-part") { frame, sink ->
            val isKept = kept?.first?.let {
                it.primitives === frame.primitives && it.width == frame.width && it.height == frame.height
            }
            val image = if (isKept == true) checkNotNull(kept).second else ZBuffer().render(frame)
            kept = frame to image
            for (y in 0 until image.height) {
                val from = y * image.width
                fun row(all: IntArray) = all.copyOfRange(from, from + image.width)
                sink.row(frame.region.rowStart + y, row(image.argb), row(image.depth), row(image.primitive))
            }
            image.counters
        }
    }

    fun failsAfterAFailure(): BrokenRenderer {
        var hasFailed = false
        return BrokenRenderer("fails-after-a-failure") { frame, sink ->
            check(!hasFailed) { "still failing" }
            hasFailed = true
            ZBuffer().render(frame, sink).also { hasFailed = false }
        }
    }

    fun swallowsExceptions() = BrokenRenderer("swallows-exceptions") { frame, sink ->
        val image = try {
            ZBuffer().render(frame)
        } catch (_: RuntimeException) {
            ZBuffer().render(Frame(frame.raster, emptyList(), frame.region))
        }
        emit(image, sink)
    }

    fun wrapsExceptions() = BrokenRenderer("wraps-exceptions") { frame, sink ->
        val image = try {
            ZBuffer().render(frame)
        } catch (e: RuntimeException) {
            throw IllegalStateException("rendering failed", e)
        }
        emit(image, sink)
    }

    fun addsToExceptions() = BrokenRenderer("adds-to-exceptions") { frame, sink ->
        try {
            ZBuffer().render(frame, sink)
        } catch (e: Throwable) {
            e.addSuppressed(IllegalStateException("rendering failed"))
            throw e
        }
    }

    fun wrapsAtTheStart() = BrokenRenderer("wraps-at-the-start") { frame, sink ->
        try {
            frame.hasTranslucency
        } catch (e: RuntimeException) {
            throw IllegalStateException("the frame is not valid", e)
        }
        ZBuffer().render(frame, sink)
    }

    fun swallowsTheSinks() = BrokenRenderer("swallows-the-sinks-exceptions") { frame, sink ->
        val image = ZBuffer().render(frame)
        val patient = RowSink { y, argb, depth, primitive ->
            try {
                sink.row(y, argb, depth, primitive)
            } catch (_: RuntimeException) {
                // Continue after the failure
            }
        }
        emit(image, patient)
    }

    fun goesOnAfterTheSinkFailed() = BrokenRenderer("goes-on-after-the-sink-failed") { frame, sink ->
        var failure: RuntimeException? = null
        val counters = emit(
            ZBuffer().render(frame),
            { y, argb, depth, primitive ->
                try {
                    sink.row(y, argb, depth, primitive)
                } catch (e: RuntimeException) {
                    failure = failure ?: e
                }
            },
        )
        failure?.let { throw it }
        counters
    }

    fun interruptedHalfWay() = BrokenRenderer("empty-when-interrupted") { frame, sink ->
        val primitives = if (Thread.interrupted()) emptyList() else frame.primitives
        ZBuffer().render(Frame(frame.raster, primitives, frame.region), sink)
    }

    fun failsWhenInterrupted() = BrokenRenderer("fails-when-interrupted") { frame, sink ->
        check(!Thread.interrupted()) { "interrupted" }
        ZBuffer().render(frame, sink)
    }

    /** Merges the pictures of two threads without comparing depths. */
    fun racyMerge(): BrokenRenderer =
        BrokenRenderer("racy-merge", options = { if (it.threads > 1) racyMerge(2) else racyMerge() }) { frame, sink ->
            ZBuffer().render(frame, sink)
        }

    private fun racyMerge(threads: Int) = BrokenRenderer("racy-merge") { frame, sink ->
        val parts = (0 until threads).map { part -> ZBuffer().render(frame.keeping { it % threads == part }) }
        emit(parts.reduce { first, second -> overwritten(first, second) }, sink)
    }

    private fun overwritten(first: Image, second: Image): Image {
        fun pick(a: IntArray, b: IntArray) =
            IntArray(a.size) { if (second.primitive[it] == DepthTest.BACKGROUND) a[it] else b[it] }
        return Image(
            first.region,
            pick(first.argb, second.argb),
            pick(first.depth, second.depth),
            pick(first.primitive, second.primitive),
            first.counters.plus(second.counters),
        )
    }

    /** If tiles are small, copies the last column of a row of tiles from the previous tile. */
    fun tileSeam() = BrokenRenderer("tile-seam", options = {
        seamed(it)
    }) { frame, sink -> ZBuffer().render(frame, sink) }

    private fun seamed(options: RenderOptions) = painting("tile-seam") { image, frame ->
        val colors = IntArray(image.argb.size) {
            val column = frame.region.columnStart + it % image.width
            image.argb[if (column % options.tileSize == 0 && it % image.width > 0) it - 1 else it]
        }
        Image(image.region, colors, image.depth, image.primitive, image.counters)
    }

    fun indexIn16Bits() = painting("index-in-16-bits") { image, _ ->
        image.renumbered { it and 0xFFFF }
    }

    /** The index of a primitive is the position of the first equal one in the list. */
    fun indexByIdentity() = painting("index-by-identity") { image, frame ->
        val first = IdentityHashMap<Any, Int>()
        frame.primitives.forEachIndexed { index, it -> first.putIfAbsent(it, index) }
        image.renumbered { index ->
            frame.primitives[index].let {
                if (it.rowStart < it.rowEnd) {
                    first.getValue(it)
                } else {
                    index
                }
            }
        }
    }
}
