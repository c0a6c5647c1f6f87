package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Counters
import dev.lazyz.RowSink
import dev.lazyz.conformance.mutants.Mistake

/** Makes a renderer that changes its counters by [change] before it returns them. */
private fun counting(change: PlainDrawing.(Counters.Builder) -> Unit) = plain {
    object : PlainDrawing(it) {
        override fun run(sink: RowSink): Counters =
            super.run(sink).toBuilder().also { counters -> change(counters) }.build()
    }
}

/** Rule 8: pictures are right, numbers are not. */
internal val counterMistakes: List<Mistake> = listOf(
    Mistake("count-fragments-by-bounds", "fragments are counted by the width of the row's spans, gaps included") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun draw(entry: Entry, y: Int) {
                    super.draw(entry, y)
                    for (i in 1 until spans.count) counters.fragments += spans.start(i) - spans.end(i - 1)
                }
            }
        }
    },
    Mistake("count-evaluations-of-starts", "a span counts one depth evaluation, its steps none") {
        plain {
            object : PlainDrawing(it) {
                override fun count(start: Int, end: Int) {
                    counters.fragments += end - start
                    counters.depthEvaluations++
                }
            }
        }
    },
    Mistake("count-passes-by-span", "a span counts one depth pass, however many samples of it pass") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
                    val before = counters.depthPasses
                    super.lower(keys, at, index, count)
                    if (counters.depthPasses > before) counters.depthPasses = before + 1
                }
            }
        }
    },
    Mistake("count-shading-by-run", "a run of one primitive counts one shading call") {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun colorRun(index: Int, y: Int, start: Int, end: Int) {
                    super.colorRun(index, y, start, end)
                    counters.shadingCalls -= end - start - 1
                    counters.shadingStarts -= end - start - 1
                }
            }
        }
    },
)
