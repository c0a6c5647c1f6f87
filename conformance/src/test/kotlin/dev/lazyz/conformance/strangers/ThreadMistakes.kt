package dev.lazyz.conformance.strangers

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService

/** Failures of workers and of the sink, interrupts, and what is left behind by threads. */
internal val threadMistakes: List<Stranger> = listOf(
    Stranger(
        "worker-failure-wrapped",
        "what a worker throws reaches the caller as the cause of another",
        setOf("7.1"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun fail(e: ExecutionException): Nothing = throw e
            }
        }
    },
    Stranger(
        "interrupt-ends-early",
        "an interrupted caller gets counters of what is done, without the rest of the rows",
        setOf("7.1", "7.3"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun doRow(y: Int, sink: RowSink) {
                    if (!Thread.currentThread().isInterrupted) super.doRow(y, sink)
                }
            }
        }
    },
    Stranger(
        "threads-left-behind",
        "the pool is not shut down; its threads wait for ever after each rendering",
        setOf("7.1"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun close(pool: ExecutorService) = Unit
            }
        }
    },
    Stranger(
        "threads-left-after-failure",
        "the pool is shut down by the last row; after a failure its threads stay",
        setOf("7.1"),
    ) {
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
    Stranger(
        "sink-in-worker",
        "the last worker of a band calls the sink, whose exception ends that band only",
        setOf("7.3"),
    ) {
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
