package dev.lazyz.conformance.probes

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Selector
import dev.lazyz.Selector.Cell
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.ShadingCursor
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicIntegerArray
import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.atomic.AtomicReference

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
        frame.primitives.mapIndexed { index, it ->
            if (isOutside(it, frame.region)) Queried(it) { found.set(index) } else it
        },
        frame.region,
    )

    /** Index of a primitive that was queried, or null. */
    val asked: Int? get() = found.get().takeIf { it != NONE }

    private fun isOutside(primitive: Primitive, region: Region): Boolean =
        maxOf(primitive.rowStart, region.rowStart) >= minOf(primitive.rowEnd, region.rowEnd) ||
            maxOf(primitive.columnStart, region.columnStart) >= minOf(primitive.columnEnd, region.columnEnd)

    private companion object {
        const val NONE = -1
    }
}

/**
 * A selector that shows the nearest fragment, computes the colour of the last, and notes for which samples of [region]
 * it is called. Thread safe.
 */
internal class CellWitness(private val region: Region) : Selector {
    private val calls = AtomicIntegerArray(region.size.toInt())
    private val problem = AtomicReference<String?>()

    override fun select(cell: Cell) {
        val (column, row) = cell.x - region.columnStart to cell.y - region.rowStart
        if (column in 0 until region.width && row in 0 until region.height) {
            calls.incrementAndGet(row * region.width + column)
        } else {
            problem.compareAndSet(null, "the selector is called for (${cell.x}, ${cell.y}), outside the region")
        }
        cell.shade(cell.size - 1)
        cell.show(0)
    }

    /** Describes a call too many or too few, or returns null. [image] is the right picture. */
    fun complaint(image: Image): String? = problem.get() ?: image.primitive.indices.firstNotNullOfOrNull { i ->
        val expected = if (image.primitive[i] == DepthTest.BACKGROUND) 0 else 1
        val place = "(${region.columnStart + i % region.width}, ${region.rowStart + i / region.width})"
        if (calls[i] == expected) null else "the selector is called ${calls[i]} times for $place, not $expected"
    }
}
