package dev.lazyz.conformance.strangers

import dev.lazyz.Counters
import dev.lazyz.Primitive
import dev.lazyz.RowSink
import dev.lazyz.Spans

/** Makes a renderer that changes its counters by [change] before it returns them. */
private fun counting(change: PlainDrawing.(Counters.Builder) -> Unit) = plain {
    object : PlainDrawing(it) {
        override fun run(sink: RowSink): Counters =
            super.run(sink).toBuilder().also { counters -> change(counters) }.build()
    }
}

/** Rule 8: pictures are right, numbers are not. */
internal val counterMistakes: List<Stranger> = listOf(
    Stranger(
        "count-primitives-that-reach",
        "primitives outside the region are not counted as submitted",
        setOf("8.1", "9.4"),
    ) {
        counting { it.primitives = primitives.count { each -> reaches(each) }.toLong() }
    },
    Stranger(
        "count-primitives-that-cover",
        "primitives that cover nothing are not counted as submitted",
        setOf("8.1", "9.4"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun draw(primitive: Primitive, index: Int) {
                    val before = counters.fragments
                    super.draw(primitive, index)
                    if (counters.fragments == before) counters.primitives--
                }
            }
        }
    },
    Stranger("count-fragments-outside-region", "fragments beside the region are counted", setOf("8.1", "7.4")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun draw(entry: Entry, y: Int) {
                    super.draw(entry, y)
                    val all = Spans()
                    entry.primitive.spans(y, all)
                    for (i in 0 until all.count) counters.fragments += all.end(i) - all.start(i)
                    for (i in 0 until spans.count) counters.fragments -= spans.end(i) - spans.start(i)
                }
            }
        }
    },
    Stranger(
        "count-fragments-by-bounds",
        "fragments are counted by the width of the row's spans, gaps included",
        setOf("8.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun draw(entry: Entry, y: Int) {
                    super.draw(entry, y)
                    for (i in 1 until spans.count) counters.fragments += spans.start(i) - spans.end(i - 1)
                }
            }
        }
    },
    Stranger(
        "count-fragments-inclusive",
        "a span that ends at the region's border counts one fragment more",
        setOf("8.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun count(start: Int, end: Int) {
                    super.count(start, end)
                    if (end == region.columnEnd) counters.fragments++
                }
            }
        }
    },
    Stranger("count-evaluations-of-starts", "a span counts one depth evaluation, its steps none", setOf("8.1")) {
        plain {
            object : PlainDrawing(it) {
                override fun count(start: Int, end: Int) {
                    counters.fragments += end - start
                    counters.depthEvaluations++
                }
            }
        }
    },
    Stranger("count-evaluations-formless-only", "only depths without a form count as evaluations", setOf("8.1")) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    super.walk(primitive, y, start, end)
                    if (primitive.depthForm != null) counters.depthEvaluations -= end - start
                }
            }
        }
    },
    Stranger(
        "count-passes-before-background",
        "depth passes are counted against an empty buffer; shows on fragments behind the background",
        setOf("8.1", "4.3"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
                    for (i in 0 until count) {
                        if (keys[at + i] == backgroundKey() && key(spanDepths[i], index) >= keys[at + i]) {
                            counters.depthPasses++
                        }
                    }
                    super.lower(keys, at, index, count)
                }
            }
        }
    },
    Stranger("count-passes-by-span", "a span counts one depth pass, however many samples of it pass", setOf("8.1")) {
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
    Stranger(
        "count-passes-with-failures",
        "every depth test counts as a pass; shows on one that fails in any order",
        setOf("8.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
                    val before = counters.depthPasses
                    super.lower(keys, at, index, count)
                    counters.depthPasses = before + count
                }
            }
        }
    },
    Stranger("count-shading-of-background", "samples of background count as shading calls", setOf("8.1", "8.2")) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun colorRow(y: Int) {
                    super.colorRow(y)
                    val background = indices.count { it < 0 }
                    counters.shadingCalls += background
                    counters.shadingStarts += background
                }
            }
        }
    },
    Stranger("count-shading-by-run", "a run of one primitive counts one shading call", setOf("8.1", "8.2")) {
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
    Stranger(
        "count-shading-of-last-row-lost",
        "the calls of the region's last row are not counted",
        setOf("8.1", "8.2"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun colorRow(y: Int) {
                    val before = counters.shadingCalls
                    val starts = counters.shadingStarts
                    super.colorRow(y)
                    if (y + 1 < region.rowEnd || region.height == 1) return
                    counters.shadingCalls = before
                    counters.shadingStarts = starts
                }
            }
        }
    },
    Stranger("count-suspensions-of-background", "columns without a primitive count as suspended", setOf("8.1")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun beginShading() {
                    super.beginShading()
                    counters.peakSuspensions = maxOf(counters.peakSuspensions, width.toLong())
                }
            }
        }
    },
    Stranger(
        "count-suspensions-added-up",
        "suspensions are added up over rows, where one row is alive at a time",
        setOf("8.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun colorRow(y: Int) {
                    val before = counters.peakSuspensions
                    counters.peakSuspensions = 0
                    super.colorRow(y)
                    counters.peakSuspensions += before
                }
            }
        }
    },
    Stranger("count-bytes-none", "peak bytes stay 0", setOf("8.3")) { counting { it.peakBytes = 0 } },
    Stranger("count-fragments-in-int", "fragments are summed as Int; shows beyond 2^31", setOf("8.1")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun count(start: Int, end: Int) {
                    counters.fragments = (counters.fragments.toInt() + (end - start)).toLong()
                    counters.depthEvaluations += end - start
                }
            }
        }
    },
)
