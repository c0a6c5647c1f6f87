package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.mutants.emit
import dev.lazyz.conformance.mutants.painting
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.util.IdentityHashMap

/** Renderers that render correctly as long as they are used in the usual way. */
internal object MannerMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::indexIn16Bits, "indices have 16 bits"),
        Mistake(::indexByIdentity, "a primitive that is submitted twice has the index of its first occurrence"),
        Mistake(::regionOffsetTwice, "rows are numbered from the region's start, twice"),
        Mistake(::looksOutsideTheRegion, "asks for the spans of all, and then for the region's"),
        Mistake(::widthOf97, "one width is wrong, which only a user's frame has"),
        Mistake(::configuresItself, "`configured` sets the options of the renderer itself"),
        Mistake(::addsToExceptions, "adds to what a primitive or the sink throws"),
        Mistake(::failsAfterAFailure, "after one failure, every later call fails"),
        Mistake(::interruptedHalfWay, "an interrupted thread gets an empty picture"),
        Mistake(::failsWhenInterrupted, "an interrupted thread gets an unrelated exception"),
        Mistake(::racyMerge, "the second thread's result overwrites the first thread's"),
    )

    fun regionOffsetTwice() = BrokenRenderer("region-offset-twice") { frame, sink ->
        ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
            sink.row(y + frame.region.rowStart, argb, depth, primitive)
        }
    }

    /** The options are set in the renderer that is asked for another one. */
    fun configuresItself(): BrokenRenderer {
        var current: Renderer = ListsRenderer()
        lateinit var itself: BrokenRenderer
        itself = BrokenRenderer(
            "configures-itself",
            setOf(Capability.SELECTION, Capability.TRANSPARENCY),
            { options -> itself.also { current = ListsRenderer(options) } },
        ) { frame, sink -> current.render(frame, sink) }
        return itself
    }

    /** Correct on all frames of the suite. */
    fun widthOf97() = BrokenRenderer("width-of-97") { frame, sink ->
        val renderer = if (frame.raster.width == 97) WrongColors() else ZBufferRenderer()
        renderer.render(frame, sink)
    }

    /** Visits all primitives before it considers the region. */
    fun looksOutsideTheRegion() = BrokenRenderer("looks-outside-the-region") { frame, sink ->
        for (it in frame.primitives) for (y in it.rowStart until it.rowEnd) it.spans(y, Spans())
        ZBufferRenderer().render(frame, sink)
    }

    fun failsAfterAFailure(): BrokenRenderer {
        var hasFailed = false
        return BrokenRenderer("fails-after-a-failure") { frame, sink ->
            check(!hasFailed) { "still failing" }
            hasFailed = true
            ZBufferRenderer().render(frame, sink).also { hasFailed = false }
        }
    }

    fun addsToExceptions() = BrokenRenderer("adds-to-exceptions") { frame, sink ->
        try {
            ZBufferRenderer().render(frame, sink)
        } catch (e: Throwable) {
            e.addSuppressed(IllegalStateException("rendering failed"))
            throw e
        }
    }

    fun interruptedHalfWay() = BrokenRenderer("empty-when-interrupted") { frame, sink ->
        val primitives = if (Thread.interrupted()) emptyList() else frame.primitives
        ZBufferRenderer().render(Frame(frame.raster, primitives, frame.region), sink)
    }

    fun failsWhenInterrupted() = BrokenRenderer("fails-when-interrupted") { frame, sink ->
        check(!Thread.interrupted()) { "interrupted" }
        ZBufferRenderer().render(frame, sink)
    }

    /** Merges the pictures of two threads without comparing depths. */
    fun racyMerge(): BrokenRenderer =
        BrokenRenderer("racy-merge", options = { if (it.threads > 1) racyMerge(2) else racyMerge() }) { frame, sink ->
            ZBufferRenderer().render(frame, sink)
        }

    private fun racyMerge(threads: Int) = BrokenRenderer("racy-merge") { frame, sink ->
        val parts = (0 until threads).map { part -> ZBufferRenderer().render(frame.keeping { it % threads == part }) }
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
