package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Primitive
import dev.lazyz.conformance.mutants.Mistake

/** The list of active primitives, and what goes from row to row. */
internal val sweepMistakes: List<Mistake> = listOf(
    Mistake(
        "arrivals-packed-in-int",
        "first row and index are sorted in one Int of two halves; shows from row 32,768 or index 65,536 on",
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun arrivals(): List<Int> = super.arrivals().map { firstRow(it) shl 16 or it }.sorted()
                    .map { it and 0xFFFF }
            }
        }
    },
    Mistake("active-256-places", "more than 256 primitives on one row: the rest is dropped") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun enter(index: Int, y: Int) {
                    if (active.size < 256) super.enter(index, y)
                }
            }
        }
    },
    Mistake(
        "empty-primitive-with-negative-height",
        "room for the rows of each primitive is asked for; one whose rowEnd is before its rowStart throws",
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
    Mistake("background-filled-once", "a row without primitives is not filled again after another such row") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private var wasEmpty = false

                override fun colorRow(y: Int) {
                    val isEmpty = indices.all { it < 0 }
                    if (!isEmpty || !wasEmpty) super.colorRow(y)
                    wasEmpty = isEmpty
                }
            }
        }
    },
)

/** Shading by steps. */
internal val stepMistakes: List<Mistake> = listOf(
    Mistake(
        "step-adaptive-always",
        "adaptive coherence steps over any gap, whatever a start costs; shows in starts and steps",
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun isNear(gap: Int, primitive: Primitive): Boolean = true
            }
        }
    },
    Mistake(
        "step-adaptive-below-cost",
        "adaptive coherence steps over gaps below the cost of a start, not up to it; shows in starts and steps",
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun isNear(gap: Int, primitive: Primitive): Boolean = super.isNear(gap + 1, primitive)
            }
        }
    },
    Mistake("step-direct-steps-too", "direct coherence steps from neighbour to neighbour") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun isStepping(primitive: Primitive): Boolean = true

                override fun isNear(gap: Int, primitive: Primitive): Boolean = gap == 1 || super.isNear(gap, primitive)
            }
        }
    },
    Mistake("step-starts-are-calls", "every call under coherence counts as a start") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun step(chain: Chain, x: Int) {
                    super.step(chain, x)
                    counters.shadingStarts++
                }
            }
        }
    },
)
