package dev.lazyz.conformance.strangers

import dev.lazyz.Coherence
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RowSink

/** The list of active primitives, and what goes from row to row. */
internal val sweepMistakes: List<Stranger> = listOf(
    Stranger(
        "active-removal-skips-next",
        "what follows a removed entry is skipped for a row; shows where a primitive ends while later ones go on",
        setOf("2.3", "5.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun drawActive(y: Int) {
                    var i = 0
                    while (i < active.size) {
                        draw(active[i], y)
                        if (active[i].primitive.rowEnd <= y + 1) active.removeAt(i)
                        i++
                    }
                }

                override fun retire(y: Int) = Unit
            }
        }
    },
    Stranger(
        "active-swap-removal",
        "the last entry takes the place of a removed one and is not looked at; it outlives its end or loses a row",
        setOf("2.3", "5.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun drawActive(y: Int) {
                    var i = 0
                    while (i < active.size) {
                        draw(active[i], y)
                        val last = active.last()
                        if (active[i].primitive.rowEnd <= y + 1) {
                            active[i] = last
                            active.removeAt(active.size - 1)
                        }
                        i++
                    }
                }

                override fun retire(y: Int) = Unit
            }
        }
    },
    Stranger(
        "active-joins-at-its-row-only",
        "a primitive joins on the row on which it begins; one that begins above the region never does",
        setOf("7.4"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun arrivals(): List<Int> =
                    super.arrivals().filter { primitives[it].rowStart >= region.rowStart }
            }
        }
    },
    Stranger(
        "cursor-from-primitive-top",
        "the cursor begins at the primitive's first row, also where the region begins below it",
        setOf("7.4", "2.3"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun enter(index: Int, y: Int) {
                    val primitive = primitives[index]
                    active.add(Entry(index, primitive, primitive.cursor(maxOf(primitive.rowStart, 0))))
                }
            }
        }
    },
    Stranger(
        "arrivals-packed-in-int",
        "first row and index are sorted in one Int of two halves; shows from row 32,768 or index 65,536 on",
        setOf("1.1", "9.4"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun arrivals(): List<Int> = super.arrivals().map { firstRow(it) shl 16 or it }.sorted()
                    .map { it and 0xFFFF }
            }
        }
    },
    Stranger("active-256-places", "more than 256 primitives on one row: the rest is dropped", setOf("5.1")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun enter(index: Int, y: Int) {
                    if (active.size < 256) super.enter(index, y)
                }
            }
        }
    },
    Stranger(
        "active-recursion",
        "the active list is a chain that is walked by recursion; some ten thousand primitives on a row " +
            "overflow the stack",
        setOf("9.5", "7.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun drawActive(y: Int) = drawFrom(0, y)

                private fun drawFrom(i: Int, y: Int) {
                    if (i == active.size) return
                    draw(active[i], y)
                    drawFrom(i + 1, y)
                    check(i < active.size)
                }
            }
        }
    },
    Stranger(
        "empty-row-keeps-depth",
        "rows without active primitives clear colour and index, but hand out the depths of the row before",
        setOf("4.3", "7.3"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private val last = IntArray(width) { raster.backgroundDepth }

                override fun handOut(y: Int, sink: RowSink) {
                    if (indices.all { it < 0 } && active.isEmpty()) last.copyInto(depths) else depths.copyInto(last)
                    super.handOut(y, sink)
                }
            }
        }
    },
    Stranger(
        "row-reuse-by-spans",
        "a row with the spans and primitives of the row above and dy 0 is not drawn again; " +
            "formless primitives count as " +
            "dy 0, which shows on a user's primitive of straight sides",
        setOf("2.8", "4.5"),
    ) {
        sweep { frame, coherence -> RowReuse(frame, coherence) }
    },
    Stranger(
        "empty-primitive-with-negative-height",
        "room for the rows of each primitive is asked for; one whose rowEnd is before its rowStart throws",
        setOf("9.4", "2.8"),
    ) {
        plain {
            object : PlainDrawing(it) {
                private var seen = 0

                override fun drawAll() {
                    for (primitive in primitives) {
                        val rows = minOf(primitive.rowEnd, raster.height) - maxOf(primitive.rowStart, 0)
                        seen = maxOf(seen, BooleanArray(rows).size)
                    }
                    super.drawAll()
                }
            }
        }
    },
    Stranger(
        "row-last-odd-column",
        "keys are turned into rows two columns at a time; the last of an odd width of more than 1 stays as it was",
        setOf("7.3", "9.6"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun finishRow(keys: LongArray, offset: Int, y: Int, sink: RowSink) {
                    if (width % 2 == 1 && width > 1) keys[offset + width - 1] = backgroundKey()
                    super.finishRow(keys, offset, y, sink)
                }
            }
        }
    },
)

/** Takes the keys of the row above where nothing seems to have changed. */
private class RowReuse(frame: Frame, coherence: Coherence) : SweepDrawing(frame, coherence) {
    private var before = emptyList<Int>()
    private val row = ArrayList<Int>()
    private val lastKeys = LongArray(width)

    override fun drawRow(y: Int) {
        row.clear()
        super.drawRow(y)
        val isLevel = row.indices.step(3).all { primitives[row[it]].depthForm?.dy ?: 0L == 0L }
        if (isLevel && row.isNotEmpty() && row == before) lastKeys.copyInto(keys) else keys.copyInto(lastKeys)
        before = row.toList()
    }

    override fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        row.addAll(listOf(index, start, end))
        super.drawSpan(primitive, index, y, start, end)
    }
}
