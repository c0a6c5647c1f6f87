package dev.lazyz.strategies.zbuffer

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.endIfInterrupted
import dev.lazyz.pipeline.GuardedDrawing
import dev.lazyz.pipeline.SampleBuffer
import dev.lazyz.raster.forEachKey
import dev.lazyz.raster.forEachPrimitive
import dev.lazyz.raster.forEachRow
import dev.lazyz.requireOpaque
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.io.IOException

/**
 * The depth buffer: draws one primitive at a time, and each sample keeps the nearest fragment so far.
 *
 * Shading is eager: a fragment that is the nearest so far is shaded immediately, even though a later primitive may hide
 * it. Use this renderer when primitives arrive one by one and there are too many to keep, or when shading is cheap. Use
 * a lazy renderer when shading is expensive.
 *
 * Memory: 12 bytes a sample, regardless of the number of primitives. Time: proportional to the number of fragments.
 * Thread safe; no state between calls.
 *
 * Source: Edwin Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", University of Utah, 1974.
 */
public class ZBufferRenderer : StreamingRenderer {
    override val id: String get() = "zbuffer"

    override val summary: String get() = "one primitive at a time, depth stepped along spans, shades whatever is nearer"

    override val capabilities: Set<Capability> get() = setOf(Capability.STREAMS_PRIMITIVES)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val buffer = Buffer(frame.raster, frame.region)
        frame.forEachPrimitive(Checkpoint.CALLER) { _, primitive -> buffer.draw(primitive) }
        return buffer.finish(sink)
    }

    override fun begin(raster: Raster, region: Region): Rendering {
        val buffer = Buffer(raster, region)
        return GuardedDrawing(this, buffer::draw, buffer::finish)
    }

    override fun toString(): String = "ZBufferRenderer()"

    /** The picture, and the work that it took so far. */
    private class Buffer(raster: Raster, private val region: Region) {
        private val test = raster.depthTest
        private val samples = SampleBuffer(raster, region)
        private val keys = samples.keys
        private val counters = Counters.Builder()
        private val fragment = Fragment()
        private val spans = region.spans()

        init {
            counters.peakBytes = samples.bytes
        }

        fun draw(primitive: Primitive) {
            val index = counters.primitives++.toInt()
            primitive.forEachRow(region, spans) { y ->
                for (i in 0 until spans.count) drawSpan(primitive, index, y, spans.start(i), spans.end(i))
            }
        }

        private fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
            counters.fragments += end - start
            counters.depthEvaluations += end - start
            var at = samples.place(start, y)
            primitive.forEachKey(index, test, y, start, end) { x, key ->
                if (key < keys[at]) {
                    keys[at] = key
                    samples.argb[at] = shade(primitive, x, y)
                }
                at++
            }
        }

        private fun shade(primitive: Primitive, x: Int, y: Int): Int {
            endIfInterrupted()
            counters.depthPasses++
            counters.shadingCalls++
            fragment.moveTo(x, y)
            primitive.shade(fragment)
            return fragment.toArgb()
        }

        fun finish(sink: RowSink): Counters {
            samples.handOut(sink)
            return counters.build()
        }
    }
}
