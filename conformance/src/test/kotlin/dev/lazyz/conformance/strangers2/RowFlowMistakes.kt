package dev.lazyz.conformance.strangers2

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import dev.lazyz.conformance.strangers.Stranger
import java.util.concurrent.atomic.AtomicReference

/** Mistakes of memory, sinks and state in a renderer that goes row by row. */
internal fun rowFlowMistakes(): List<Stranger> = listOf(
    wrongRows("tries-again", "a row that the sink refuses with a runtime exception is handed out once more", "7.3") {
        object : RowSteps() {
            override fun handOut(pass: RowPass, y: Int) = try {
                super.handOut(pass, y)
            } catch (_: RuntimeException) {
                super.handOut(pass, y)
            }
        }
    },
    wrongRows("interrupted-is-done", "asks every 16 rows whether it is interrupted, and then returns", "7.1", "7.3") {
        object : RowSteps() {
            override fun goesOn(pass: RowPass, y: Int): Boolean = y % 16 != 15 || !Thread.currentThread().isInterrupted
        }
    },
    wrongRows("remembers-failed-frame", "after a rendering that failed the frame is still held", "7.1") {
        object : RowSteps() {
            private var current: Frame? = null

            override fun begin(frame: Frame) {
                current = frame
            }

            override fun end(frame: Frame) {
                if (current === frame) current = null
            }
        }
    },
    wrongRows("one-row-ahead", "spans are asked for one row before they are needed", "7.6") {
        object : RowSteps() {
            override fun admit(pass: RowPass, index: Int, y: Int) {
                val primitive = pass.frame.primitives[index]
                val end = minOf(primitive.rowEnd, pass.region.rowEnd)
                pass.active.add(Active(index, primitive, Ahead(primitive, y, end, pass)))
            }
        }
    },
    wrongRows("table-of-rows", "a table with an entry for each row of the region", "7.6") {
        object : RowSteps() {
            override fun keys(pass: RowPass): LongArray = LongArray(pass.width + pass.region.height)

            override fun finish(pass: RowPass) {
                pass.counters.peakBytes += 8L * pass.region.height
            }
        }
    },
    wrongRows("kept-keys", "keys of the last rendering are taken for cleared, whatever the background", "7.1") {
        object : RowSteps() {
            private val kept = AtomicReference<LongArray?>()

            override fun keys(pass: RowPass): LongArray {
                val old = kept.getAndSet(null)
                return if (old?.size == pass.width) old else super.keys(pass).also { it.fill(pass.backgroundKey) }
            }

            override fun clear(pass: RowPass) = Unit

            override fun handOut(pass: RowPass, y: Int) {
                super.handOut(pass, y)
                pass.keys.fill(pass.backgroundKey)
            }

            override fun finish(pass: RowPass) = kept.set(pass.keys)
        }
    },
    wrongRows("shared-row", "two renderings of one width at once hand out the same array of depths", "7.1") {
        object : RowSteps() {
            private val shared = AtomicReference(IntArray(0))

            override fun goesOn(pass: RowPass, y: Int): Boolean {
                if (y > pass.region.rowStart) return true
                if (shared.get().size != pass.width) shared.set(IntArray(pass.width))
                pass.depths = shared.get()
                return true
            }
        }
    },
    wrongRows("asks-beside", "makes a cursor for what lies beside the region on its rows", "7.7") {
        object : RowSteps() {
            override fun reaches(pass: RowPass, primitive: Primitive): Boolean =
                maxOf(primitive.rowStart, pass.region.rowStart) < minOf(primitive.rowEnd, pass.region.rowEnd)
        }
    },
)

/** A cursor that reads a row ahead. */
private class Ahead(primitive: Primitive, private var y: Int, private val end: Int, pass: RowPass) : SpanCursor {
    private val cursor = primitive.cursor(y)
    private val coming = Spans(pass.region)
    private var isAhead = false

    override fun next(spans: Spans) {
        spans.clear()
        if (!isAhead) cursor.next(coming)
        for (i in 0 until coming.count) spans.add(coming.start(i), coming.end(i))
        isAhead = ++y < end
        if (isAhead) cursor.next(coming)
    }
}
