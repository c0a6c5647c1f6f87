package dev.lazyz.conformance.strangers

import dev.lazyz.Primitive

/** Shading by steps. */
internal val stepMistakes: List<Stranger> = listOf(
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
