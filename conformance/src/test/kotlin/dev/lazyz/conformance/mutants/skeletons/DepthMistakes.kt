package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.conformance.mutants.Mistake

/** Depth along a span, the depth test, ties and the background. */
internal val depthMistakes: List<Mistake> = listOf(
    Mistake(
        "depth-formless-per-4",
        "depth without a form evaluated at every fourth column of runs of 16 and more; shows on spheres that wide",
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    super.walk(primitive, y, start, end)
                    if (primitive.depthForm != null || end - start < 16) return
                    for (i in 0 until end - start) spanDepths[i] = spanDepths[i - i % 4]
                }
            }
        }
    },
    Mistake("key-float", "depths compared as Float; shows where two differ by few units") {
        plain {
            object : PlainDrawing(it) {
                override fun passes(key: Long, best: Long): Boolean {
                    val depth = (key ushr 32).toFloat()
                    val bestDepth = (best ushr 32).toFloat()
                    return if (depth == bestDepth) key.toInt() < best.toInt() else depth < bestDepth
                }
            }
        }
    },
    Mistake("key-index-16-bits", "16 bits of the key for the index; shows from 65,536 primitives on") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun key(depth: Int, index: Int): Long = test.key(depth, index and 0xFFFF)
            }
        }
    },
    Mistake(
        "tie-by-place-in-list",
        "ties go to what is earlier in the active list, which is in order of first rows; shows on ties " +
            "of primitives that begin on different rows",
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
                    for (i in 0 until count) {
                        val key = key(spanDepths[i], index)
                        val best = keys[at + i]
                        val isEmpty = test.indexOf(best) == DepthTest.BACKGROUND
                        val isBefore = if (isEmpty) key < best else key ushr 32 < best ushr 32
                        if (isBefore) keys[at + i] = key.also { counters.depthPasses++ }
                    }
                }
            }
        }
    },
    Mistake("background-depth-ignored", "the raster's background depth is ignored") {
        plain {
            object : PlainDrawing(it) {
                override fun backgroundKey(): Long = test.key(raster.convention.farthest, DepthTest.BACKGROUND)
            }
        }
    },
    Mistake(
        "background-loses-ties",
        "a fragment as deep as the background is visible, whatever the test; shows with LESS and GREATER",
    ) {
        sweep { frame, coherence -> BackgroundLosesTies(frame, coherence) }
    },
    Mistake("background-opaque", "the background's alpha is taken for 1") {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun backgroundArgb(): Int = super.backgroundArgb() or (0xFF shl 24)
            }
        }
    },
)

private class BackgroundLosesTies(frame: Frame, coherence: Coherence) : SweepDrawing(frame, coherence) {
    override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
        for (i in 0 until count) {
            val isBackground = test.indexOf(keys[at + i]) == DepthTest.BACKGROUND
            if (isBackground && spanDepths[i] == raster.backgroundDepth) keys[at + i] = Long.MAX_VALUE
        }
        super.lower(keys, at, index, count)
    }
}

/** What shows on large rasters or many primitives only. */
internal val largeMistakes: List<Mistake> = listOf(
    Mistake(
        "large-depth-slope-in-int",
        "depth is stepped from column 0 with 16 bits of fraction; shows at columns far to the right",
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    val form = primitive.depthForm ?: return super.walk(primitive, y, start, end)
                    val atStart = form.at(start, y)
                    val slope = form.dx shr 16 shl 16
                    for (x in start until end) {
                        spanDepths[x - start] = (atStart - form.dx * start + slope * x shr 32).toInt()
                    }
                }
            }
        }
    },
)
