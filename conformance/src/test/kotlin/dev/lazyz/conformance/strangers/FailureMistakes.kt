package dev.lazyz.conformance.strangers

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.Spans
import java.util.concurrent.ConcurrentHashMap

/** What stays from one rendering to the next, and what becomes of failures. */
internal val failureMistakes: List<Stranger> = listOf(
    Stranger(
        "state-colors-by-place",
        "colours are kept by primitive's index and sample over renderings; shows on a second frame",
        setOf("7.1"),
    ) {
        val kept = ConcurrentHashMap<List<Int>, Int>()
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun color(index: Int, x: Int, y: Int): Int {
                    val color = super.color(index, x, y)
                    return if (region.size > 4096) color else kept.putIfAbsent(listOf(index, x, y), color) ?: color
                }
            }
        }
    },
    Stranger(
        "state-arrivals-by-raster",
        "the sorted list of arrivals is kept for the next frame of as many primitives and the same raster",
        setOf("7.1"),
    ) {
        val kept = ConcurrentHashMap<String, List<Int>>()
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun arrivals(): List<Int> {
                    val arrivals = super.arrivals()
                    val known = kept.putIfAbsent("$raster $region ${primitives.size}", arrivals) ?: arrivals
                    return known.sortedBy { firstRow(it) }
                }
            }
        }
    },
    Stranger(
        "state-dirty-after-failure",
        "keys are taken from a pool, and cleared as they are given back, but not when a rendering fails",
        setOf("7.1"),
    ) {
        val pool = ConcurrentHashMap<Int, LongArray>()
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private val pooled = pool.remove(width) ?: LongArray(width) { Long.MAX_VALUE }
                override val keys: LongArray get() = pooled

                override fun run(sink: RowSink): Counters = try {
                    super.run(sink)
                } finally {
                    pool[width] = pooled
                }

                override fun drawRow(y: Int) {
                    val old = pooled.clone()
                    super.drawRow(y)
                    for (i in 0 until width) pooled[i] = minOf(pooled[i], old[i])
                }

                override fun finishRow(keys: LongArray, offset: Int, y: Int, sink: RowSink) {
                    super.finishRow(keys, offset, y, sink)
                    keys.fill(Long.MAX_VALUE)
                }
            }
        }
    },
    Stranger(
        "state-shared-row",
        "all renderings of a renderer share the arrays of the row; shows on two threads, or in a sink that renders",
        setOf("7.1"),
    ) {
        val rows = ConcurrentHashMap<Int, IntArray>()
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun doRow(y: Int, sink: RowSink) {
                    indices = rows.getOrPut(width) { IntArray(width) }
                    super.doRow(y, sink)
                }
            }
        }
    },
    Stranger(
        "state-background-of-first",
        "the background colour of the first frame is used for all",
        setOf("7.1", "4.3"),
    ) {
        var first: Int? = null
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun backgroundArgb(): Int = first ?: super.backgroundArgb().also { first = it }
            }
        }
    },
    Stranger("state-counters-of-all", "counters are those of all renderings so far", setOf("7.1", "8.1")) {
        var sum = Counters.NONE
        plain {
            object : PlainDrawing(it) {
                override fun run(sink: RowSink): Counters {
                    sum = sum.plus(super.run(sink))
                    return sum
                }
            }
        }
    },
    Stranger("failure-of-shader-is-magenta", "a sample whose shader throws is magenta", setOf("7.1")) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun color(index: Int, x: Int, y: Int): Int = try {
                    super.color(index, x, y)
                } catch (_: RuntimeException) {
                    0xFFFF00FF.toInt()
                }
            }
        }
    },
    Stranger("failure-of-shader-wrapped", "what a shader throws is wrapped with the primitive's index", setOf("7.1")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun color(index: Int, x: Int, y: Int): Int = try {
                    super.color(index, x, y)
                } catch (e: RuntimeException) {
                    throw IllegalStateException("primitive $index", e)
                }
            }
        }
    },
    Stranger(
        "failure-of-primitive-skips-it",
        "a primitive that throws when it is asked for its spans is left out",
        setOf("7.1"),
    ) {
        tiles { frame: Frame, size ->
            object : TileDrawing(frame, size) {
                override fun drawTile(tile: Region, bin: IntArray) {
                    val sound = bin.filter { index ->
                        runCatching { primitives[index].spans(tile.rowStart, Spans(tile)) }.isSuccess
                    }
                    super.drawTile(tile, sound.toIntArray())
                }
            }
        }
    },
)
