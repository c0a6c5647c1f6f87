package dev.lazyz.conformance.strangers

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import java.util.concurrent.CancellationException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Future

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
        "worker-error-wrapped",
        "exceptions of workers are thrown on, errors are wrapped; shows where a shader throws an AssertionError",
        setOf("7.1"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun fail(e: ExecutionException): Nothing =
                    throw e.cause as? Exception ?: IllegalStateException(e)
            }
        }
    },
    Stranger("worker-failure-swallowed", "a band whose shader throws stays background", setOf("7.1")) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun drawBand(band: Region, number: Int): Image = try {
                    super.drawBand(band, number)
                } catch (_: IllegalStateException) {
                    emptyImage(band)
                }
            }
        }
    },
    Stranger(
        "worker-failure-copied",
        "what a worker throws is made anew with the caller's stack; another object of the same class and message",
        setOf("7.1"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun fail(e: ExecutionException): Nothing = throw copyOf(e.cause ?: e)

                private fun copyOf(cause: Throwable): Throwable = runCatching {
                    cause.javaClass.getConstructor(String::class.java).newInstance(cause.message)
                }.getOrDefault(cause)
            }
        }
    },
    Stranger(
        "interrupt-leaves-bands-out",
        "an interrupted caller takes the band that it waits for as empty, and goes on",
        setOf("7.1"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun drawBands(pool: ExecutorService, sink: RowSink) {
                    for ((number, band) in bands().withIndex()) {
                        val future = pool.submit<Image> { drawBand(band, number) }
                        val image = try {
                            await(future)
                        } catch (_: InterruptedException) {
                            emptyImage(band)
                        }
                        join(image.counters)
                        for (y in band.rowStart until band.rowEnd) handOutRow(image, y, sink)
                    }
                }
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
        "interrupt-wrapped",
        "an InterruptedException becomes an IllegalStateException",
        setOf("7.1"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun await(band: Future<Image>): Image = try {
                    super.await(band)
                } catch (e: InterruptedException) {
                    throw IllegalStateException("interrupted", e)
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
        "hang-without-primitives",
        "waits for the first primitive to be drawn; for ever where there is none",
        setOf("9.6"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                private val begun = CountDownLatch(1)

                override fun drawBand(band: Region, number: Int): Image {
                    if (primitives.isNotEmpty()) begun.countDown()
                    return super.drawBand(band, number)
                }

                override fun await(band: Future<Image>): Image = super.await(band).also { begun.await() }
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
    Stranger("sink-called-after-failure", "the rows that are left go to a sink that has thrown", setOf("7.3")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private var failure: Throwable? = null

                override fun handOut(y: Int, sink: RowSink) {
                    runCatching { super.handOut(y, sink) }.onFailure { failure = failure ?: it }
                    if (y == region.rowEnd - 1) failure?.let { throw it }
                }
            }
        }
    },
    Stranger("sink-failure-wrapped", "what the sink throws is wrapped with the row's number", setOf("7.3")) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun handOut(y: Int, sink: RowSink) = try {
                    super.handOut(y, sink)
                } catch (e: RuntimeException) {
                    throw IllegalStateException("row $y", e)
                }
            }
        }
    },
    Stranger(
        "sink-cancellation-swallowed",
        "a CancellationException of the sink ends the rendering as if all were well",
        setOf("7.3"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private var isCancelled = false

                override fun doRow(y: Int, sink: RowSink) {
                    if (isCancelled) return
                    try {
                        super.doRow(y, sink)
                    } catch (_: CancellationException) {
                        isCancelled = true
                    }
                }
            }
        }
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
