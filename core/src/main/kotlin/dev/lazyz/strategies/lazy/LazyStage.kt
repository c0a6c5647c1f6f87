package dev.lazyz.strategies.lazy

import dev.lazyz.Frame
import dev.lazyz.Spans
import dev.lazyz.pipeline.Row
import dev.lazyz.pipeline.Stage

/**
 * A stage that is a coroutine: between two rows it is suspended in the middle of its primitive.
 *
 * In the paper a stage demands its upstream row itself, so that a demand at the end of the chain becomes as many calls
 * within calls as there are stages. All that happens on the way up is calling. Here [next] is told the upstream row: who
 * pulls begins at the upstream end, where that demand would have arrived, and resumes the stages in the order in which
 * they would have returned. The evaluations and their order are the paper's; the stack does not grow with the chain.
 */
internal class LazyStage(frame: Frame, index: Int, y: Int, spans: Spans) : Stage(frame, index, y, spans) {
    /** The row that upstream has ready. */
    private val upstream = Upstream()
    private val downstream = rows(y, upstream).iterator()

    override val bytes: Long get() = super.bytes + BYTES

    override fun next(upstream: Row): Row {
        this.upstream.row = upstream
        return downstream.next()
    }

    /** The rows below this stage: those above it, with this primitive drawn. */
    private fun rows(y: Int, upstream: Iterator<Row>): Sequence<Row> = sequence {
        repeat(rowEnd - y) { yield(transform(upstream.next())) }
    }

    private class Upstream : Iterator<Row> {
        var row: Row? = null

        override fun hasNext(): Boolean = row != null

        override fun next(): Row = row!!.also { row = null }
    }

    private companion object {
        const val BYTES = 136L
    }
}
