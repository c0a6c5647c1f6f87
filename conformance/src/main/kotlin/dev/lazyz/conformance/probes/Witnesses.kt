package dev.lazyz.conformance.probes

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.ShadingCursor
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/** Counts the shading calls of the primitives of [frame] in all threads. */
internal class ShadingWitness(frame: Frame) {
    private val calls = AtomicLong()
    private val direct = AtomicLong()
    private val cursors = AtomicLong()
    private val stepped = AtomicLong()
    private val longest = AtomicLong()

    /** The frame with the observed primitives. */
    val frame: Frame = Frame(frame.raster, frame.primitives.map { Watched(it) }, frame.region)

    /** Number of colours computed so far, by [Primitive.shade] or by [ShadingCursor.shade]. */
    val count: Long get() = calls.get()

    /**
     * Number of colours so far whose attributes were evaluated at the sample: by [Primitive.shade], or the first of a
     * cursor.
     */
    val starts: Long get() = direct.get() + cursors.get()

    /** Number of cursor steps so far. */
    val steps: Long get() = stepped.get()

    /** Greatest number of steps so far to a cursor's first colour or between two of its colours. */
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

/** Counts the depths that primitives of [frame] are asked for; these have no linear form. Thread safe. */
internal class DepthWitness(frame: Frame) {
    private val calls = AtomicLong()

    /** The frame with the observed primitives. */
    val frame: Frame = Frame(frame.raster, frame.primitives.map { Watched(it) }, frame.region)

    /** Number of depths so far. */
    val count: Long get() = calls.get()

    private inner class Watched(private val primitive: Primitive) : Primitive by primitive {
        override val depthForm: LinearForm? get() = null

        override fun depth(x: Int, y: Int): Int {
            calls.incrementAndGet()
            return primitive.depth(x, y)
        }
    }
}

/** Records a primitive of [frame] that lies wholly outside its region but is queried for more than its bounds. */
internal class OutsideWitness(frame: Frame) {
    private val found = AtomicInteger(NONE)

    /** The frame with the observed primitives. */
    val frame: Frame = Frame(
        frame.raster,
        frame.primitives.mapIndexed { index, it -> if (isOutside(it, frame.region)) Watched(it, index) else it },
        frame.region,
    )

    /** Index of a primitive that was queried, or null. */
    val asked: Int? get() = found.get().takeIf { it != NONE }

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
        const val NONE = -1
    }
}
