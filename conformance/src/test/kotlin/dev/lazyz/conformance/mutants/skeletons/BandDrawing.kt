package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import java.util.concurrent.Callable
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.Future
import java.util.concurrent.TimeUnit

/** Bands of rows, each drawn by some worker; the caller hands them out in order. */
internal open class BandDrawing(frame: Frame, options: RenderOptions) : Drawing(frame) {
    val threads = options.threads
    val window = 2 * minOf(threads, MOST_THREADS)
    val bandRows = if (width <= WIDE) 8 else 1

    override fun run(sink: RowSink): Counters {
        counters.primitives = primitives.size.toLong()
        val pool = pool()
        try {
            drawBands(pool, sink)
        } finally {
            close(pool)
        }
        counters.primitives = primitives.size.toLong()
        counters.peakBytes += 12L * window * bandRows * width
        return counters.build()
    }

    open fun drawBands(pool: ExecutorService, sink: RowSink) {
        val bands = bands()
        val waiting = ArrayDeque<Future<Image>>()
        var next = 0
        while (true) {
            while (next < bands.size && waiting.size < window) {
                val number = next++
                waiting.add(pool.submit(Callable { drawBand(bands[number], number) }))
            }
            val image = await(waiting.removeFirstOrNull() ?: return)
            join(image.counters)
            for (y in image.region.rowStart until image.region.rowEnd) handOutRow(image, y, sink)
        }
    }

    open fun poolSize(): Int = minOf(threads, MOST_THREADS)

    open fun pool(): ExecutorService = Executors.newFixedThreadPool(poolSize()) { work ->
        Thread(work, "band").also { it.isDaemon = true }
    }

    open fun close(pool: ExecutorService) {
        pool.shutdownNow()
        pool.awaitTermination(CLOSING_SECONDS, TimeUnit.SECONDS)
    }

    open fun bands(): List<Region> = (region.rowStart until region.rowEnd step bandRows).map {
        Region(region.columnStart, it, region.columnEnd, minOf(it + bandRows, region.rowEnd))
    }

    /** Draws a band on a worker. */
    open fun drawBand(band: Region, number: Int): Image {
        val collector = Image.Collector(band)
        return collector.toImage(worker(frame.within(band)).run(collector))
    }

    open fun worker(part: Frame): Drawing = SweepDrawing(part, Coherence.DIRECT)

    open fun await(band: Future<Image>): Image = try {
        band.get()
    } catch (e: ExecutionException) {
        fail(e)
    }

    open fun fail(e: ExecutionException): Nothing = throw e.cause ?: e

    open fun join(part: Counters) {
        counters.fragments += part.fragments
        counters.depthEvaluations += part.depthEvaluations
        counters.depthPasses += part.depthPasses
        counters.shadingCalls += part.shadingCalls
        counters.shadingStarts += part.shadingStarts
        counters.peakSuspensions = maxOf(counters.peakSuspensions, part.peakSuspensions)
        counters.peakBytes = maxOf(counters.peakBytes, part.peakBytes)
    }

    open fun handOutRow(image: Image, y: Int, sink: RowSink) {
        val at = (y - image.region.rowStart) * width
        image.argb.copyInto(argb, 0, at, at + width)
        image.depth.copyInto(depths, 0, at, at + width)
        image.primitive.copyInto(indices, 0, at, at + width)
        handOut(y, sink)
    }

    private companion object {
        const val MOST_THREADS = 16
        const val WIDE = 4096
        const val CLOSING_SECONDS = 10L
    }
}

internal fun bands(drawing: (Frame, RenderOptions) -> BandDrawing): Renderer = Workbench(
    "bands", { setOf(Capability.PARALLEL, Capability.SHADES_ONLY_VISIBLE) }, drawing = drawing,
)
