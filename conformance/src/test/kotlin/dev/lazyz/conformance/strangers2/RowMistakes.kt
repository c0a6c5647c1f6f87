package dev.lazyz.conformance.strangers2

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import dev.lazyz.conformance.strangers.Stranger

internal fun wrongRows(id: String, what: String, vararg chapters: String, steps: () -> RowSteps): Stranger =
    Stranger(id, what, chapters.toSet()) { RowByRow(steps(), RenderOptions()) }

/** Mistakes of coverage, depth and background in a renderer that goes row by row. */
internal fun rowMistakes(): List<Stranger> = listOf(
    wrongRows("late-cursor", "a cursor begins at the primitive's first row, not the region's", "7.4", "2.3") {
        object : RowSteps() {
            override fun cursor(primitive: Primitive, y: Int): SpanCursor =
                primitive.cursor(maxOf(primitive.rowStart, 0))
        }
    },
    wrongRows("clipped-start", "a span that begins left of the region has its first depths there", "7.4", "3.1") {
        object : RowSteps() {
            override fun draw(pass: RowPass, one: Active, y: Int) {
                val form = one.primitive.depthForm ?: return super.draw(pass, one, y)
                val spans = Spans()
                one.cursor.next(spans)
                for (i in 0 until spans.count) {
                    var z = form.at(spans.start(i), y)
                    val start = maxOf(spans.start(i), pass.region.columnStart)
                    val end = minOf(spans.end(i), pass.region.columnEnd)
                    for (x in start until end) {
                        merge(pass, one.index, x, (z shr 32).toInt())
                        z += form.dx
                    }
                    pass.counters.fragments += maxOf(end - start, 0)
                    pass.counters.depthEvaluations += maxOf(end - start, 0)
                }
            }
        }
    },
    wrongRows("sixteen-spans", "room for 16 spans of a primitive on a row; the others are dropped", "2.3", "2.4") {
        object : RowSteps() {
            override fun draw(pass: RowPass, one: Active, y: Int) {
                one.cursor.next(pass.spans)
                for (i in 0 until minOf(pass.spans.count, 16)) {
                    span(pass, one, y, pass.spans.start(i), pass.spans.end(i))
                }
            }
        }
    },
    wrongRows("chunks-of-64", "every 64 columns of a span depth goes on from its integer part", "3.1", "3.2") {
        object : RowSteps() {
            override fun span(pass: RowPass, one: Active, y: Int, start: Int, end: Int) {
                val form = one.primitive.depthForm ?: return super.span(pass, one, y, start, end)
                pass.counters.fragments += end - start
                pass.counters.depthEvaluations += end - start
                var z = form.at(start, y)
                for (x in start until end) {
                    if (x > start && (x - start) % 64 == 0) z = (z shr 32 shl 32) + (1L shl 31)
                    merge(pass, one.index, x, (z shr 32).toInt())
                    z += form.dx
                }
            }
        }
    },
    wrongRows("index-of-16-bits", "keeps 16 bits of the index of a primitive: wrong from 65,536 primitives on", "5.1") {
        object : RowSteps() {
            override fun index(arrival: Long): Int = super.index(arrival) and 0xFFFF
        }
    },
    wrongRows("column-of-16-bits", "keeps 16 bits of a span's ends: wrong right of column 65,535", "1.1", "2.3") {
        object : RowSteps() {
            override fun span(pass: RowPass, one: Active, y: Int, start: Int, end: Int) =
                super.span(pass, one, y, start and 0xFFFF, end and 0xFFFF)
        }
    },
    wrongRows(
        "cursor-falls-behind", "the cursor is not moved on where a primitive's bounds are hidden", "2.3", "5.1",
    ) {
        object : RowSteps() {
            override fun draw(pass: RowPass, one: Active, y: Int) {
                val first = maxOf(one.primitive.columnStart, pass.region.columnStart) - pass.region.columnStart
                val end = minOf(one.primitive.columnEnd, pass.region.columnEnd) - pass.region.columnStart
                val isReversed = pass.test.key(1, 0) < pass.test.key(0, 0)
                val bound = if (isReversed) one.primitive.greatestDepth else one.primitive.leastDepth
                val nearest = pass.test.key(bound, one.index)
                if ((first until end).any { pass.keys[it] > nearest }) super.draw(pass, one, y)
            }
        }
    },
    wrongRows("every-other-depth", "curved depth in spans over 16 columns: every other one is a mean", "4.5", "5.1") {
        object : RowSteps() {
            override fun span(pass: RowPass, one: Active, y: Int, start: Int, end: Int) {
                if (one.primitive.depthForm != null || end - start <= 16) return super.span(pass, one, y, start, end)
                pass.counters.fragments += end - start
                pass.counters.depthEvaluations += end - start
                for (x in start until end) merge(pass, one.index, x, depth(one.primitive, x, y, start, end))
            }

            private fun depth(primitive: Primitive, x: Int, y: Int, start: Int, end: Int): Int {
                if ((x - start) % 2 == 0 || x + 1 == end) return primitive.depth(x, y)
                return ((primitive.depth(x - 1, y).toLong() + primitive.depth(x + 1, y)) / 2).toInt()
            }
        }
    },
    wrongRows("idle-rows", "rows on which no primitive is active have the depths of the row before", "4.3") {
        object : RowSteps() {
            override fun resolve(pass: RowPass, y: Int) {
                if (y == pass.region.rowStart || pass.active.isNotEmpty()) return super.resolve(pass, y)
                pass.argb.fill(pass.background)
                pass.indices.fill(DepthTest.BACKGROUND)
            }
        }
    },
    wrongRows("refuses-in-sight", "refuses what is translucent only if its bounds reach into the region", "5.6") {
        object : RowSteps() {
            override fun check(frame: Frame) = Unit

            override fun begin(frame: Frame) {
                val columns = frame.region.columnStart until frame.region.columnEnd
                val rows = frame.region.rowStart until frame.region.rowEnd
                val index = frame.primitives.indexOfFirst { it.isTranslucent && overlaps(it, columns, rows) }
                if (index >= 0) refuse(index, "row-by-row")
            }
        }
    },
)
