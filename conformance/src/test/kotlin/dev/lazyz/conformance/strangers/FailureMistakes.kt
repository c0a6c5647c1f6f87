package dev.lazyz.conformance.strangers

import dev.lazyz.RowSink
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
)
