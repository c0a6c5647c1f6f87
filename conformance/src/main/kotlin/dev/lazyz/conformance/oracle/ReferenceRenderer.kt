package dev.lazyz.conformance.oracle

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.io.IOException

/**
 * The oracle: queries every primitive at every sample and compares as contract rule 5 defines, nothing else.
 *
 * It shares no code with the strategies: no cursors, no linear forms, no [DepthTest.key], no bounds. Each primitive is
 * queried on every row of the raster. Use it to check a renderer, not to render. Thread safe; no state between calls.
 *
 * It trusts the spans, depths and colours of primitives. Tests with exact arithmetic check primitives against the
 * contract: [ExactPolygon], [ExactProjection] and [ExactSphere] compute coverage and depth from vertices, without the
 * code of set-up, and [ExactPicture] the visible primitive. This renderer is tested against those, and all others are
 * tested against this one by the suite. So a mistake in set-up that all strategies share is also found.
 *
 * Time: samples x primitives. Memory: one row. Shading calls: exactly the visible samples, and where a translucent
 * primitive is visible, the fragments that show through.
 */
public class ReferenceRenderer : Renderer {
    override val id: String get() = "reference"

    override val summary: String get() = "queries every primitive at every sample as the contract says; for comparison"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.CONSTANT_MEMORY,
            Capability.STREAMS_ROWS,
            Capability.TRANSPARENCY,
        )

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        val row = Row(frame)
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            row.clear()
            for (index in frame.primitives.indices) row.compare(index, y)
            row.shade(y)
            if (frame.hasTranslucency) row.blend(y)
            sink.row(y, row.argb, row.depth, row.primitive)
        }
        return row.counters.build()
    }

    private class Row(private val frame: Frame) {
        private val raster = frame.raster
        private val firstColumn = frame.region.columnStart
        private val spans = Spans()
        private val fragment = Fragment()
        val argb = IntArray(frame.width)
        val depth = IntArray(frame.width)
        val primitive = IntArray(frame.width)
        val counters = Counters.Builder().apply {
            primitives = frame.primitives.size.toLong()
            peakBytes = 12L * frame.width
        }

        /** Sets every sample to the background's colour, depth and index (rule 4.3). */
        fun clear() {
            argb.fill(raster.background.toArgb())
            depth.fill(raster.backgroundDepth)
            primitive.fill(DepthTest.BACKGROUND)
        }

        /** Compares the primitive with this submission index at the samples of row [y] that it covers. */
        fun compare(index: Int, y: Int) {
            spans.clear()
            frame.primitives[index].spans(y, spans)
            for (i in 0 until frame.width) {
                val x = firstColumn + i
                if (!spans.contains(x)) continue
                counters.fragments++
                counters.depthEvaluations++
                val own = frame.primitives[index].depth(x, y)
                if (raster.depthTest.prefers(own, index, depth[i], primitive[i])) {
                    counters.depthPasses++
                    depth[i] = own
                    primitive[i] = index
                }
            }
        }

        /** Sets every sample of row [y] to the colour of its visible primitive. */
        fun shade(y: Int) {
            for (i in 0 until frame.width) {
                if (primitive[i] == DepthTest.BACKGROUND || frame.primitives[primitive[i]].isTranslucent) continue
                shade(primitive[i], firstColumn + i, y)
                argb[i] = fragment.toArgb()
            }
        }

        private fun shade(index: Int, x: Int, y: Int) {
            counters.shadingCalls++
            fragment.moveTo(x, y)
            frame.primitives[index].shade(fragment)
        }

        /** Blends where a translucent primitive is visible, as rule 5.5 defines. */
        fun blend(y: Int) {
            for (i in 0 until frame.width) {
                if (primitive[i] == DepthTest.BACKGROUND || !frame.primitives[primitive[i]].isTranslucent) continue
                argb[i] = blended(frame.fragments(firstColumn + i, y), firstColumn + i, y).toArgb()
            }
        }

        private fun blended(nearestFirst: List<Int>, x: Int, y: Int): Rgba {
            val layers = nearestFirst.map {
                BlendedSample.Layer(frame.primitives[it].isTranslucent) { color(it, x, y) }
            }
            return BlendedSample.of(layers, raster.background)
        }

        private fun color(index: Int, x: Int, y: Int): Rgba {
            shade(index, x, y)
            return Rgba(fragment.red, fragment.green, fragment.blue, fragment.alpha)
        }
    }
}

/** Returns whether the fragment ([depth], [index]) hides the other one, as rules 5.1 to 5.3 define. */
private fun DepthTest.prefers(depth: Int, index: Int, otherDepth: Int, otherIndex: Int): Boolean = when (this) {
    DepthTest.LESS -> depth < otherDepth || (depth == otherDepth && index < otherIndex)
    DepthTest.LESS_OR_EQUAL -> depth < otherDepth || (depth == otherDepth && index > otherIndex)
    DepthTest.GREATER -> depth > otherDepth || (depth == otherDepth && index < otherIndex)
    DepthTest.GREATER_OR_EQUAL -> depth > otherDepth || (depth == otherDepth && index > otherIndex)
}

private fun Spans.contains(x: Int): Boolean = (0 until count).any { x >= start(it) && x < end(it) }

/** Returns whether the primitive says that it covers a sample. */
internal fun Primitive.covers(x: Int, y: Int): Boolean = Spans().also { spans(y, it) }.contains(x)

/** Returns the indices of all primitives that cover a sample and pass against the background, nearest first. */
internal fun Frame.fragments(x: Int, y: Int): List<Int> {
    val test = raster.depthTest
    val passing = primitives.indices.filter {
        primitives[it].covers(x, y) &&
            test.prefers(primitives[it].depth(x, y), it, raster.backgroundDepth, DepthTest.BACKGROUND)
    }
    return passing.sortedWith { a, b ->
        if (test.prefers(primitives[a].depth(x, y), a, primitives[b].depth(x, y), b)) -1 else 1
    }
}

/** The colour of a sample with translucent fragments, which are added from near to far (contract rule 5.5). */
internal class BlendedSample private constructor() {
    private var transmittance = 1f
    private val sums = FloatArray(4)

    /** Whether further fragments can change the colour. */
    private val isOpen: Boolean get() = transmittance > 0f

    /** Whether a fragment with an alpha above 0 has been added. */
    private val hasColor: Boolean get() = sums[3] != 0f

    /** The colour of the fragments so far; there must be one with an alpha above 0. */
    private val color: Rgba get() = Rgba(sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3], sums[3])

    /** Adds the next fragment, or the backdrop, behind the others. */
    private fun add(color: Rgba) {
        val a = if (color.alpha > 0f) minOf(color.alpha, 1f) else 0f
        if (a == 0f) return
        val w = transmittance * a
        sums[0] += w * color.red
        sums[1] += w * color.green
        sums[2] += w * color.blue
        sums[3] += w
        transmittance *= 1f - a
    }

    /** A fragment. Its [color] is asked for only if it shows. */
    class Layer(val isTranslucent: Boolean, val color: () -> Rgba)

    companion object {
        /** Returns what a sample shows whose fragments are [nearestFirst], before [background]. */
        fun of(nearestFirst: List<Layer>, background: Rgba): Rgba {
            val sample = BlendedSample()
            for (layer in nearestFirst) {
                if (!layer.isTranslucent) break
                if (sample.isOpen) sample.add(layer.color())
            }
            if (!sample.isOpen) return sample.color
            val backdrop = nearestFirst.firstOrNull { !it.isTranslucent }
            val behind = if (backdrop == null) background else backdrop.color()
            if (!sample.hasColor) return behind
            sample.add(behind)
            return sample.color
        }
    }
}
