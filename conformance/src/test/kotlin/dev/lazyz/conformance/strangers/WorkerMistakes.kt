package dev.lazyz.conformance.strangers

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import java.util.concurrent.ExecutorCompletionService
import java.util.concurrent.ExecutorService

/** Bands of rows and their counters, where several threads draw. */
internal val workerMistakes: List<Stranger> = listOf(
    Stranger(
        "bands-remainder-rows",
        "rows are dealt to the threads in equal parts, what remains is nobody's; shows where threads do not " +
            "divide rows",
        setOf("7.5"),
    ) {
        bands { frame, options -> EqualParts(frame, options) }
    },
    Stranger(
        "bands-last-of-one-row",
        "a last band of one row is left out, and its row is background; shows on heights of a multiple of 8 plus 1",
        setOf("7.3", "9.6"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun drawBand(band: Region, number: Int): Image =
                    if (number == 0 || band.height > 1) super.drawBand(band, number) else emptyImage(band)
            }
        }
    },
    Stranger(
        "bands-shared-keys",
        "all workers draw into the keys of one buffer; shows with several threads",
        setOf("7.5"),
    ) {
        bands { frame, options -> SharedKeys(frame, options) }
    },
    Stranger(
        "bands-lost-updates",
        "the workers add to one set of counters without a lock; shows with several threads",
        setOf("7.6", "8.1"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun worker(part: Frame): Drawing = SharedCounters(part, counters)

                override fun join(part: Counters) = Unit
            }
        }
    },
    Stranger(
        "bands-last-counters",
        "the counters of the last band are not added; shows on 2 bands and more",
        setOf("8.1", "7.6"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                private var before: Counters? = null

                override fun join(part: Counters) {
                    before?.let { super.join(it) } ?: super.join(Counters.NONE)
                    before = part
                }
            }
        }
    },
    Stranger("bands-primitives-each", "every band adds the primitives that are submitted", setOf("8.1", "7.6")) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                private var joined = 0

                override fun join(part: Counters) {
                    super.join(part)
                    joined++
                }

                override fun run(sink: RowSink): Counters =
                    super.run(sink).toBuilder().apply { primitives *= joined }.build()
            }
        }
    },
    Stranger(
        "bands-suspensions-by-threads",
        "peak suspensions are multiplied by the threads; counters depend on their number",
        setOf("7.6"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun run(sink: RowSink): Counters =
                    super.run(sink).toBuilder().apply { peakSuspensions *= threads }.build()
            }
        }
    },
    Stranger(
        "bands-one-worker",
        "all bands go through one lock; one thread is at work, whatever the options",
        setOf("7.6"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun drawBand(band: Region, number: Int): Image =
                    synchronized(counters) { super.drawBand(band, number) }
            }
        }
    },
    Stranger("bands-one-thread-less", "the caller is thought to work too; two threads are one at work", setOf("7.6")) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun poolSize(): Int = maxOf(1, super.poolSize() - 1)
            }
        }
    },
    Stranger(
        "bands-overlap-by-a-row",
        "bands begin a row early; that row is drawn twice, which shows in the counters of two bands and more",
        setOf("8.1", "8.2"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun drawBand(band: Region, number: Int): Image {
                    val image = super.drawBand(band, number)
                    if (number == 0) return image
                    val above = Region(band.columnStart, band.rowStart - 1, band.columnEnd, band.rowStart)
                    return Image(band, image.argb, image.depth, image.primitive, both(above, number, image))
                }

                private fun both(above: Region, number: Int, image: Image): Counters =
                    super.drawBand(above, number).counters.plus(image.counters)
            }
        }
    },
    Stranger(
        "bands-hand-out-as-done",
        "rows are handed out by whichever band is done first; shows with several threads and bands of unequal cost",
        setOf("7.3"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun drawBands(pool: ExecutorService, sink: RowSink) {
                    val done = ExecutorCompletionService<Image>(pool)
                    val bands = bands()
                    for ((number, band) in bands.withIndex()) done.submit { drawBand(band, number) }
                    repeat(bands.size) {
                        val image = await(done.take())
                        join(image.counters)
                        for (y in image.region.rowStart until image.region.rowEnd) handOutRow(image, y, sink)
                    }
                }
            }
        }
    },
)

/** A picture of nothing. */
internal fun BandDrawing.emptyImage(band: Region): Image {
    val size = band.size.toInt()
    return Image(
        band, IntArray(size) { backgroundArgb() }, IntArray(size) { raster.backgroundDepth }, IntArray(size) { -1 },
        Counters.NONE,
    )
}

private class EqualParts(frame: Frame, options: RenderOptions) : BandDrawing(frame, options) {
    private val drawn = region.height / threads * threads

    override fun drawBand(band: Region, number: Int): Image {
        if (threads == 1 || band.rowEnd - region.rowStart <= drawn) return super.drawBand(band, number)
        val empty = emptyImage(band)
        val rows = drawn - (band.rowStart - region.rowStart)
        if (rows <= 0) return empty
        val part = Region(band.columnStart, band.rowStart, band.columnEnd, band.rowStart + rows)
        val upper = super.drawBand(part, number)
        upper.argb.copyInto(empty.argb)
        upper.depth.copyInto(empty.depth)
        upper.primitive.copyInto(empty.primitive)
        return Image(band, empty.argb, empty.depth, empty.primitive, upper.counters)
    }
}

/** Draws a band like [SweepDrawing], into [keys] that the caller has. */
private class SharedKeys(frame: Frame, options: RenderOptions) : BandDrawing(frame, options) {
    private val shared = LongArray(width)

    override fun worker(part: Frame): Drawing = object : SweepDrawing(part, Coherence.DIRECT) {
        override val keys: LongArray get() = shared
    }
}

/** Counts into [shared], and into its own counters nothing. */
private class SharedCounters(part: Frame, private val shared: Counters.Builder) : SweepDrawing(part, Coherence.DIRECT) {
    override fun count(start: Int, end: Int) {
        shared.fragments += end - start
        shared.depthEvaluations += end - start
    }

    override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
        val before = counters.depthPasses
        super.lower(keys, at, index, count)
        shared.depthPasses += counters.depthPasses - before
    }

    override fun color(index: Int, x: Int, y: Int): Int {
        shared.shadingCalls++
        shared.shadingStarts++
        shared.peakBytes = maxOf(shared.peakBytes, counters.peakBytes)
        shared.peakSuspensions = maxOf(shared.peakSuspensions, counters.peakSuspensions)
        return super.color(index, x, y)
    }
}
