package dev.lazyz.conformance.strangers

import dev.lazyz.Coherence
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive

/** Depth along a span, the depth test, ties and the background. */
internal val depthMistakes: List<Stranger> = listOf(
    Stranger(
        "depth-float-slope",
        "slope of depth kept as Float; shows on sloping spans of some columns",
        setOf("3.1"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    val form = primitive.depthForm ?: return super.walk(primitive, y, start, end)
                    val slope = form.dx.toFloat()
                    for (x in start until end) {
                        spanDepths[x - start] = (form.at(start, y) + (slope * (x - start)).toLong() shr 32).toInt()
                    }
                }
            }
        }
    },
    Stranger(
        "depth-remainder-of-8",
        "blocks of 8 columns; the rest of a span begins at the last block's depth again; shows on sloping spans of " +
            "more than 8 columns that are no multiple of 8 long",
        setOf("3.1", "4.4"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    super.walk(primitive, y, start, end)
                    val form = primitive.depthForm ?: return
                    val rest = (end - start) % 8
                    if (end - start < 8 || rest == 0) return
                    for (x in end - rest until end) spanDepths[x - start] = (form.at(x - 8, y) shr 32).toInt()
                }
            }
        }
    },
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
    Stranger(
        "depth-formless-linear",
        "a primitive without a form is stepped linearly between the span's ends; shows on spheres",
        setOf("4.5", "2.8"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    if (primitive.depthForm != null) return super.walk(primitive, y, start, end)
                    val first = primitive.depth(start, y).toLong()
                    val last = primitive.depth(end - 1, y)
                    for (i in 0 until end - start) {
                        spanDepths[i] = (first + (last - first) * i / maxOf(1, end - start - 1)).toInt()
                    }
                }
            }
        }
    },
    Stranger("depth-of-first-row", "depth of a flat-bottomed span: dy is taken for whole units", setOf("3.1", "3.2")) {
        plain {
            object : PlainDrawing(it) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    val form = primitive.depthForm ?: return super.walk(primitive, y, start, end)
                    val down = y - primitive.rowStart
                    val atTop = form.at(start, primitive.rowStart) + (form.dy shr 32 shl 32) * down
                    for (x in start until end) spanDepths[x - start] = (atTop + form.dx * (x - start) shr 32).toInt()
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
        "key-run-of-16-is-less",
        "runs of 16 and more compare depths with < whatever the depth test; shows with the three other tests",
        setOf("5.3"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
                    if (count < 16) return super.lower(keys, at, index, count)
                    for (i in 0 until count) {
                        val isEmpty = test.indexOf(keys[at + i]) == DepthTest.BACKGROUND
                        val key = key(spanDepths[i], index)
                        val isLess = spanDepths[i] < test.depthOf(keys[at + i])
                        if (!(if (isEmpty) key < keys[at + i] else isLess)) continue
                        keys[at + i] = key
                        counters.depthPasses++
                    }
                }
            }
        }
    },
    Stranger(
        "tie-never-last",
        "a tie never replaces; shows with the tests that let the last win",
        setOf("5.3", "5.2"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun passes(key: Long, best: Long): Boolean = key ushr 32 < best ushr 32
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
        "background-convention-not-test",
        "the default background depth is that of the depth test's far end, in place of the " +
            "raster's; shows where test " +
            "and convention differ",
        setOf("4.3", "4.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun backgroundKey(): Long {
                    val isUsual = raster.backgroundDepth == raster.convention.farthest
                    val isGreatest = test == DepthTest.GREATER || test == DepthTest.GREATER_OR_EQUAL
                    val convention = DepthConvention.entries[if (isGreatest) 1 else 0]
                    return test.key(if (isUsual) convention.farthest else raster.backgroundDepth, DepthTest.BACKGROUND)
                }
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
