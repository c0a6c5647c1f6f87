package dev.lazyz.conformance.strangers

import dev.lazyz.Primitive

/** Shading by steps. */
internal val stepMistakes: List<Stranger> = listOf(
    Stranger(
        "step-once-a-sample",
        "one step a visible sample, also over a gap; shows behind narrow primitives",
        setOf("7.5"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun step(chain: Chain, x: Int) = super.step(chain, minOf(x, chain.x + 1))
            }
        }
    },
    Stranger(
        "step-chains-of-last-row",
        "chains are kept from row to row; shows where one would go on to the right",
        setOf("7.5"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun beginShading() = Unit

                override fun isNear(gap: Int, primitive: Primitive): Boolean = gap >= 0 && super.isNear(gap, primitive)
            }
        }
    },
    Stranger("step-gaps-in-byte", "a gap is kept in a Byte; shows on gaps of 128 columns and more", setOf("7.5")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun step(chain: Chain, x: Int) {
                    val gap = (x - chain.x).toByte()
                    repeat(gap.toInt()) { chain.cursor.step() }
                    chain.x = x
                    counters.shadingSteps += gap
                    counters.longestChain = maxOf(counters.longestChain, gap.toLong())
                }
            }
        }
    },
    Stranger(
        "step-adaptive-always",
        "adaptive coherence steps over any gap, whatever a start costs; shows in starts and steps",
        setOf("7.6", "8.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun isNear(gap: Int, primitive: Primitive): Boolean = true
            }
        }
    },
    Stranger(
        "step-adaptive-below-cost",
        "adaptive coherence steps over gaps below the cost of a start, not up to it; shows in starts and steps",
        setOf("7.6", "8.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun isNear(gap: Int, primitive: Primitive): Boolean = super.isNear(gap + 1, primitive)
            }
        }
    },
    Stranger("step-direct-steps-too", "direct coherence steps from neighbour to neighbour", setOf("7.6", "8.1")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun isStepping(primitive: Primitive): Boolean = true

                override fun isNear(gap: Int, primitive: Primitive): Boolean = gap == 1 || super.isNear(gap, primitive)
            }
        }
    },
    Stranger(
        "step-longest-of-all",
        "the longest chain is the sum of a chain's steps, not the most of a call",
        setOf("8.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private val steps = HashMap<Chain, Long>()

                override fun step(chain: Chain, x: Int) {
                    val all = steps.merge(chain, (x - chain.x).toLong(), Long::plus)!!
                    super.step(chain, x)
                    counters.longestChain = maxOf(counters.longestChain, all)
                }
            }
        }
    },
    Stranger("step-not-counted-over-gaps", "a call counts one step, however long its gap is", setOf("8.1")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun step(chain: Chain, x: Int) {
                    val before = counters.shadingSteps
                    super.step(chain, x)
                    counters.shadingSteps = before + 1
                }
            }
        }
    },
    Stranger("step-starts-are-calls", "every call under coherence counts as a start", setOf("8.1")) {
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
