package dev.lazyz.pipeline

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.FrameParts
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.Workers
import dev.lazyz.opaqueNeeded

/**
 * Renders a streamed frame part by part. Each part is rendered like a frame of its own, where it may be seen; a sample
 * of it replaces that of the parts before if it is nearer. The nearest fragment is a minimum of keys, so the picture
 * does not depend on how the primitives are divided into parts.
 *
 * If the picture would take more than [mostBytes], it is rendered in bands of rows, with a pass over the parts for
 * each band. Parts that do not reach a band are not read for it. While a part is rendered, another thread reads the
 * next one.
 *
 * Memory: 12 bytes a sample of a band, and three parts. Used by one thread.
 *
 * Source: Steven Molnar, Michael Cox, David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering",
 * IEEE Computer Graphics and Applications 14 (1994): "sort-last", here one part after the other.
 *
 * @param mostBytes most bytes of a band, unless a row has more
 * @param renderPart renders one part
 */
internal class StreamedRendering(
    private val frame: Frame,
    private val parts: FrameParts,
    private val workers: Workers,
    private val mostBytes: Long,
    private val renderPart: (part: Frame, sink: RowSink) -> Counters,
) {
    private val test = frame.raster.depthTest
    private val counters = Counters.Builder()

    /** Renders all parts, and passes every row to [sink]. */
    fun run(sink: RowSink): Counters {
        var bytes = 0L
        for (band in bandsOf(frame.region, mostBytes)) {
            val samples = SampleBuffer(frame.raster, band)
            bytes = maxOf(bytes, samples.bytes)
            inOrder(parts.reaching(band), workers) { part ->
                val seen = part.reach.within(band)
                if (seen != null) {
                    counters.add(renderPart(Frame(frame.raster, part.content, seen), Merge(samples, part.first, seen)))
                }
            }
            samples.handOut(sink)
        }
        counters.primitives = parts.size.toLong()
        counters.peakBytes += bytes
        return counters.build()
    }

    /** Keeps the samples of a part that are nearer than those of the parts before. */
    private inner class Merge(private val samples: SampleBuffer, private val first: Int, private val seen: Region) :
        RowSink {
        override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
            val keys = samples.keys
            val start = samples.place(seen.columnStart, y)
            for (i in 0 until seen.width) {
                if (primitive[i] == DepthTest.BACKGROUND) continue
                val key = test.key(depth[i], first + primitive[i])
                if (key < keys[start + i]) {
                    keys[start + i] = key
                    samples.argb[start + i] = argb[i]
                }
            }
        }
    }
}

/** Returns bands of rows of [region], from top to bottom, that each take at most [mostBytes] or have one row. */
internal fun bandsOf(region: Region, mostBytes: Long): List<Region> {
    val samples = minOf(mostBytes / SampleBuffer.BYTES_PER_SAMPLE, Image.MAX_SAMPLES)
    val rows = (samples / region.width).coerceIn(1, region.height.toLong()).toInt()
    return (region.rowStart until region.rowEnd step rows).map { region.rows(it, it + rows) }
}

/** Returns most bytes of a band: the [limit] of the options, or a third of the heap. */
internal fun bandBytes(limit: Long?): Long = limit ?: (Runtime.getRuntime().maxMemory() / 3)

/**
 * A [Rendering]. Checks what callers may do, and leaves the work to [draw] and [end].
 *
 * @param draw draws the next primitive
 * @param end passes the rows to the sink
 */
internal class GuardedDrawing(
    private val renderer: Renderer,
    private val draw: (primitive: Primitive) -> Unit,
    private val end: (sink: RowSink) -> Counters,
) : Rendering {
    private val isBlending = Capability.TRANSPARENCY in renderer.capabilities
    private var count = 0
    private var hasEnded = false

    override fun add(primitive: Primitive) {
        check(!hasEnded) { "the image has ended: begin a new one" }
        check(count < Int.MAX_VALUE) { "more than 2^31-1 primitives" }

        // If the primitive throws an exception, it may be drawn in part, so that the image cannot be continued
        hasEnded = true
        val isRefused = !isBlending && primitive.isTranslucent
        if (!isRefused) draw(primitive)
        hasEnded = false
        if (isRefused) throw opaqueNeeded(count, renderer)
        count++
    }

    override fun finish(sink: RowSink): Counters {
        check(!hasEnded) { "the image has ended: begin a new one" }
        hasEnded = true
        return end(sink)
    }
}
