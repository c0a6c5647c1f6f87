package dev.lazyz.conformance.probes.threads

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.util.concurrent.atomic.LongAdder

/** Where the primitives of a [Crowd] make threads meet. */
internal enum class Where(
    /**
     * Number of meetings that are enough. Threads that compare and write without a lock lose an update in about one of
     * thirty meetings; a shared fragment is noticed in nearly every one.
     */
    val enough: Int,
) {
    /** At the same row, and at the same sample when its depth is queried: two updates of the same sample. */
    SAME_SAMPLE(1_000),

    /** At any query for spans or colours: two uses of state that must belong to one thread. */
    ANY_SAMPLE(1_000),
}

/**
 * A frame whose primitives cover all samples and, if [meeting] is given, make threads meet. The nearest primitive
 * varies from sample to sample.
 */
internal class Crowd(
    private val salt: Long,
    private val where: Where,
    private val meeting: Meeting?,
    private val kind: KindOfWork = KindOfWork.OPAQUE,
) {
    val frame: Frame = Frame(Raster(SIDE, SIDE), List(COUNT) { Member(it) })

    private val shaded = LongAdder()

    /** Number of shading calls so far. */
    val shadingCalls: Long get() = shaded.sum()

    private fun hash(index: Int, x: Int, y: Int): Int {
        var h = salt + index * 0x632BE59BD9B4E019L + (y * SIDE + x) * -0x61C8864680B583EBL
        h = (h xor (h ushr 32)) * -0x2917014799A6026DL
        return (h ushr 34).toInt()
    }

    /** Returns the same frame without meetings. */
    fun quiet(): FrameCase = FrameCase(
        Crowd(salt, where, null, kind).frame,
        "SuiteFrames.crowd(${salt}L, \"$where\", \"$kind\")",
    )

    /** Returns the step of a sample, for threads that visit rows from left to right. */
    private fun step(x: Int, y: Int): Int = y * (SIDE + 1) + 1 + x

    private inner class Member(private val index: Int) : Primitive {
        override val rowStart: Int get() = 0
        override val rowEnd: Int get() = SIDE
        override val columnStart: Int get() = 0
        override val columnEnd: Int get() = SIDE

        override val isTranslucent: Boolean get() = kind == KindOfWork.TRANSLUCENT

        override fun spans(y: Int, spans: Spans) {
            if (y !in 0 until SIDE) return
            meeting?.meet(if (where == Where.SAME_SAMPLE) step(-1, y) else 0)
            spans.add(0, SIDE / 2 - 1)
            if (where == Where.ANY_SAMPLE) meeting?.meet(0)
            spans.add(SIDE / 2, SIDE)
        }

        override fun depth(x: Int, y: Int): Int {
            val depth = hash(index, x, y)
            if (where == Where.SAME_SAMPLE) meeting?.meet(step(x, y))
            return depth
        }

        override fun shade(fragment: Fragment) {
            shaded.increment()
            if (where == Where.ANY_SAMPLE) meeting?.meet(0)
            val bits = hash(index + COUNT, fragment.x, fragment.y)
            val alpha = if (isTranslucent) (bits shr 24 and 31) / 32f else 1f
            fragment.setColor((bits and 255) / 255f, (bits shr 8 and 255) / 255f, (bits shr 16 and 255) / 255f, alpha)
            if (where == Where.ANY_SAMPLE) meeting?.meet(0)
        }
    }

    companion object {
        const val SIDE = 64
        const val COUNT = 4

        /** Number of covered samples. The bounds of depth are loose, so that no sample is rejected early. */
        const val FRAGMENTS: Long = COUNT * SIDE * (SIDE - 1L)
    }
}
