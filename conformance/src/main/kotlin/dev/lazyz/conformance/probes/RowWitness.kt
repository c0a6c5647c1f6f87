package dev.lazyz.conformance.probes

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import java.util.concurrent.atomic.AtomicInteger

/** Records the lowest row for which the primitives of [frame] were queried for spans, depths or colours. */
internal class RowWitness(frame: Frame) {
    private val deepest = AtomicInteger(-1)

    /** The frame with the observed primitives. */
    val frame: Frame = Frame(frame.raster, frame.primitives.map { Watched(it) }, frame.region)

    /** The lowest row that was queried, or -1. */
    val last: Int get() = deepest.get()

    private fun note(y: Int) {
        deepest.accumulateAndGet(y, ::maxOf)
    }

    private inner class Watched(private val primitive: Primitive) : Primitive by primitive {
        override fun spans(y: Int, spans: Spans) {
            note(y)
            primitive.spans(y, spans)
        }

        override fun cursor(y: Int): SpanCursor {
            note(y)
            val cursor = primitive.cursor(y)
            var row = y
            return SpanCursor {
                note(row++)
                cursor.next(it)
            }
        }

        override fun depth(x: Int, y: Int): Int {
            note(y)
            return primitive.depth(x, y)
        }

        override fun shade(fragment: Fragment) {
            note(fragment.y)
            primitive.shade(fragment)
        }

        override fun shadingCursor(x: Int, y: Int): ShadingCursor? {
            note(y)
            return primitive.shadingCursor(x, y)
        }
    }
}
