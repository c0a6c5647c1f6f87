package dev.lazyz.cli.render

import dev.lazyz.RowSink
import dev.lazyz.cli.output.Progress
import dev.lazyz.cli.output.Streams

/** Shows on the terminal how many rows are done. */
internal class ProgressSink private constructor(private val progress: Progress) : RowSink {
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) = progress.advance()

    companion object {
        /** Returns a sink for a picture of so many [rows], or null if there is no terminal. */
        fun of(streams: Streams, rows: Int): ProgressSink? =
            if (streams.isProgressShown) ProgressSink(Progress(streams, rows, "rows")) else null
    }
}
