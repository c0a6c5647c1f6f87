package dev.lazyz.strategies.lazy

import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Spans
import dev.lazyz.pipeline.Row
import dev.lazyz.pipeline.Stage

/**
 * A stage that is a coroutine: between two rows it is suspended in the middle of its primitive.
 *
 * In the paper each stage demands its upstream row itself. A demand at the end of the chain thus becomes as many nested
 * calls as there are stages, and no other work happens on the way up. Here [next] receives the upstream row: the caller
 * starts at the upstream end, where that demand would have arrived, and resumes the stages in the order in which the
 * nested calls would have returned. The evaluations and their order are the same as in the paper, but the stack does
 * not grow with the chain.
 */
internal class LazyStage(frame: Frame, index: Int, y: Int, spans: Spans) : Stage(frame, index, y, spans) {
    /** The next upstream row. */
    private val upstream = Upstream()
    private val downstream = rows(y, upstream).iterator()

    override val bytes: Long get() = super.bytes + HeapLayout.COROUTINE

    override fun next(upstream: Row): Row {
        this.upstream.row = upstream
        return downstream.next()
    }

    /** Returns the downstream rows: the upstream rows with this primitive drawn. */
    private fun rows(y: Int, upstream: Iterator<Row>): Sequence<Row> = sequence {
        repeat(rowEnd - y) { yield(transform(upstream.next())) }
    }

    private class Upstream : Iterator<Row> {
        var row: Row? = null

        override fun hasNext(): Boolean = row != null

        override fun next(): Row = row!!.also { row = null }
    }
}
