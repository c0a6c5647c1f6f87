package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.RowSink
import dev.lazyz.conformance.mutants.Mistake
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService

/** Bands of rows and their counters, where several threads draw. */
internal val workerMistakes: List<Mistake> = listOf(
    Mistake("bands-shared-keys", "all workers draw into the keys of one buffer; shows with several threads") {
        bands { frame, options -> SharedKeys(frame, options) }
    },
    Mistake(
        "bands-suspensions-by-threads",
        "peak suspensions are multiplied by the threads; counters depend on their number",
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun run(sink: RowSink): Counters =
                    super.run(sink).toBuilder().apply { peakSuspensions *= threads }.build()
            }
        }
    },
)

/** Draws a band like [SweepDrawing], into [keys] that the caller has. */
private class SharedKeys(frame: Frame, options: RenderOptions) : BandDrawing(frame, options) {
    private val shared = LongArray(width)

    override fun worker(part: Frame): Drawing = object : SweepDrawing(part, Coherence.DIRECT) {
        override val keys: LongArray get() = shared
    }
}

/** Failures of workers and of the sink, interrupts, and what is left behind by threads. */
internal val threadMistakes: List<Mistake> = listOf(
    Mistake("worker-failure-wrapped", "what a worker throws reaches the caller as the cause of another") {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun fail(e: ExecutionException): Nothing = throw e
            }
        }
    },
    Mistake(
        "interrupt-ends-early", "an interrupted caller gets counters of what is done, without the rest of the rows",
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun doRow(y: Int, sink: RowSink) {
                    if (!Thread.currentThread().isInterrupted) super.doRow(y, sink)
                }
            }
        }
    },
    Mistake("threads-left-behind", "the pool is not shut down; its threads wait for ever after each rendering") {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun close(pool: ExecutorService) = Unit
            }
        }
    },
    Mistake("threads-left-after-failure", "the pool is shut down by the last row; after a failure its threads stay") {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                private var isDone = false

                override fun drawBands(pool: ExecutorService, sink: RowSink) {
                    super.drawBands(pool, sink)
                    isDone = true
                }

                override fun close(pool: ExecutorService) {
                    if (isDone) super.close(pool)
                }
            }
        }
    },
    Mistake("sink-in-worker", "the last worker of a band calls the sink, whose exception ends that band only") {
        bands { frame, options -> SinkInWorker(frame, options) }
    },
)

/** Hands out each band on a worker, in order. */
private class SinkInWorker(frame: Frame, options: RenderOptions) : BandDrawing(frame, options) {
    override fun drawBands(pool: ExecutorService, sink: RowSink) {
        for ((number, band) in bands().withIndex()) {
            val image = await(pool.submit<Image> { drawBand(band, number) })
            join(image.counters)
            val handed = pool.submit { for (y in band.rowStart until band.rowEnd) handOutRow(image, y, sink) }
            while (!handed.isDone) Thread.sleep(0, NANOSECONDS)
        }
    }

    private companion object {
        const val NANOSECONDS = 1000
    }
}

/** What stays from one rendering to the next, and what becomes of failures. */
internal val failureMistakes: List<Mistake> = listOf(
    Mistake(
        "state-colors-by-place",
        "colours are kept by primitive's index and sample over renderings; shows on a second frame",
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
    Mistake(
        "state-arrivals-by-raster",
        "the sorted list of arrivals is kept for the next frame of as many primitives and the same raster",
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
    Mistake(
        "state-shared-row",
        "all renderings of a renderer share the arrays of the row; shows on two threads, or in a sink that renders",
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
    Mistake("state-background-of-first", "the background colour of the first frame is used for all") {
        var first: Int? = null
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun backgroundArgb(): Int = first ?: super.backgroundArgb().also { first = it }
            }
        }
    },
    Mistake("failure-of-shader-is-magenta", "a sample whose shader throws is magenta") {
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
