package dev.lazyz.conformance.probes

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.ShadingCursor
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/** Counts how often the primitives of [frame] are shaded, whoever asks. */
internal class ShadingWitness(frame: Frame) {
    private val calls = AtomicLong()
    private val direct = AtomicLong()
    private val cursors = AtomicLong()
    private val stepped = AtomicLong()
    private val longest = AtomicLong()

    /** The frame whose primitives are watched. */
    val frame: Frame = Frame(frame.raster, frame.primitives.map { Watched(it) }, frame.region)

    /** Colours computed so far, by [Primitive.shade] or by [ShadingCursor.shade]. */
    val count: Long get() = calls.get()

    /** Colours whose attributes were evaluated at the sample so far: by [Primitive.shade], or first of a cursor. */
    val starts: Long get() = direct.get() + cursors.get()

    /** Steps of cursors so far. */
    val steps: Long get() = stepped.get()

    /** Most steps from one colour of a cursor to the next so far, or to the first. */
    val longestChain: Long get() = longest.get()

    private inner class Watched(private val primitive: Primitive) : Primitive by primitive {
        override fun shade(fragment: Fragment) {
            calls.incrementAndGet()
            direct.incrementAndGet()
            primitive.shade(fragment)
        }

        override fun shadingCursor(x: Int, y: Int): ShadingCursor? =
            primitive.shadingCursor(x, y)?.let {
                cursors.incrementAndGet()
                WatchedCursor(it)
            }
    }

    private inner class WatchedCursor(private val cursor: ShadingCursor) : ShadingCursor {
        private var chain = 0L

        override fun step() {
            chain++
            stepped.incrementAndGet()
            cursor.step()
        }

        override fun shade(fragment: Fragment) {
            calls.incrementAndGet()
            longest.accumulateAndGet(chain, ::maxOf)
            chain = 0
            cursor.shade(fragment)
        }
    }
}

/** Notes which primitives of [frame] that lie wholly outside its region are asked for more than their bounds. */
internal class OutsideWitness(frame: Frame) {
    private val found = AtomicInteger(NOBODY)

    /** The frame whose primitives are watched. */
    val frame: Frame = Frame(
        frame.raster,
        frame.primitives.mapIndexed { index, it -> if (isOutside(it, frame.region)) Watched(it, index) else it },
        frame.region,
    )

    /** Number of a primitive that was asked, or null. */
    val asked: Int? get() = found.get().takeIf { it != NOBODY }

    private fun isOutside(primitive: Primitive, region: Region): Boolean =
        maxOf(primitive.rowStart, region.rowStart) >= minOf(primitive.rowEnd, region.rowEnd) ||
            maxOf(primitive.columnStart, region.columnStart) >= minOf(primitive.columnEnd, region.columnEnd)

    private inner class Watched(private val primitive: Primitive, private val index: Int) : Primitive by primitive {
        override fun spans(y: Int, spans: Spans) {
            found.set(index)
            primitive.spans(y, spans)
        }

        override fun cursor(y: Int): SpanCursor {
            found.set(index)
            return primitive.cursor(y)
        }

        override fun depth(x: Int, y: Int): Int {
            found.set(index)
            return primitive.depth(x, y)
        }

        override fun shade(fragment: Fragment) {
            found.set(index)
            primitive.shade(fragment)
        }

        override fun shadingCursor(x: Int, y: Int): ShadingCursor? {
            found.set(index)
            return primitive.shadingCursor(x, y)
        }
    }

    private companion object {
        const val NOBODY = -1
    }
}
