package dev.lazyz.conformance.strangers


/** The list of active primitives, and what goes from row to row. */
internal val sweepMistakes: List<Stranger> = listOf(
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
)
