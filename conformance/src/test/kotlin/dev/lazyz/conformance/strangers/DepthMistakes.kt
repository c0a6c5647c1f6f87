package dev.lazyz.conformance.strangers

import dev.lazyz.Coherence
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive

/** Depth along a span, the depth test, ties and the background. */
internal val depthMistakes: List<Stranger> = listOf(
    Stranger(
        "depth-formless-per-4",
        "depth without a form evaluated at every fourth column of runs of 16 and more; shows on spheres that wide",
        setOf("4.5"),
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
    Stranger("key-float", "depths compared as Float; shows where two differ by few units", setOf("5.1")) {
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
    Stranger(
        "key-index-16-bits",
        "16 bits of the key for the index; shows from 65,536 primitives on",
        setOf("5.1", "9.4"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun key(depth: Int, index: Int): Long = test.key(depth, index and 0xFFFF)
            }
        }
    },
    Stranger(
        "tie-by-place-in-list",
        "ties go to what is earlier in the active list, which is in order of first rows; shows on " +
            "ties of primitives that " +
            "begin on different rows",
        setOf("5.2"),
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
    Stranger("background-at-infinity", "the raster's background depth is ignored", setOf("4.3")) {
        plain {
            object : PlainDrawing(it) {
                override fun backgroundKey(): Long = test.key(raster.convention.farthest, DepthTest.BACKGROUND)
            }
        }
    },
    Stranger(
        "background-loses-ties",
        "a fragment as deep as the background is visible, whatever the test; shows with LESS and GREATER",
        setOf("5.2", "4.3"),
    ) {
        sweep { frame, coherence -> BackgroundLosesTies(frame, coherence) }
    },
    Stranger("background-opaque", "the background's alpha is taken for 1", setOf("6.4", "4.3")) {
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
