package dev.lazyz.aov

import dev.lazyz.DepthTest
import dev.lazyz.FrameContent
import dev.lazyz.Primitive
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.distance
import dev.lazyz.endIfInterrupted
import dev.lazyz.filter.SampledFrame
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingObserver
import dev.lazyz.spi.Spans
import java.util.concurrent.atomic.AtomicIntegerArray

/** The AOVs of work: how often something happens at the samples of a pixel. */
internal object WorkAovs {
    /** Counts the fragments of [sampled]. */
    fun overdraw(sampled: SampledFrame): AovImage {
        val counts = IntArray(Math.toIntExact(sampled.pixels.size))
        val spans = Spans()
        sampled.frame.content.forEachDrawn { primitive ->
            endIfInterrupted()
            addFragments(sampled, primitive, spans, counts)
        }
        return AovImage(Aov.OVERDRAW, sampled.pixels, counts, samplesPerPixel(sampled))
    }

    private fun samplesPerPixel(sampled: SampledFrame) = sampled.sampling.factor * sampled.sampling.factor

    private fun addFragments(sampled: SampledFrame, primitive: Primitive, spans: Spans, counts: IntArray) {
        val pixels = sampled.pixels
        val factor = sampled.sampling.factor
        val firstColumn = pixels.columnStart * factor
        val endColumn = pixels.columnEnd * factor
        if (primitive.columnStart >= endColumn || primitive.columnEnd <= firstColumn) return
        val end = minOf(primitive.rowEnd, pixels.rowEnd * factor)
        for (y in maxOf(primitive.rowStart, pixels.rowStart * factor) until end) {
            spans.clear()
            primitive.spans(y, spans)
            val row = (y / factor - pixels.rowStart) * pixels.width - pixels.columnStart
            for (i in 0 until spans.count) {
                // The part of the span in each pixel
                var x = maxOf(spans.start(i), firstColumn)
                val until = minOf(spans.end(i), endColumn)
                while (x < until) {
                    val next = minOf((x / factor + 1) * factor, until)
                    val at = row + x / factor
                    counts[at] = minOf(counts[at].toLong() + (next - x), Int.MAX_VALUE.toLong()).toInt()
                    x = next
                }
            }
        }
    }

    /** Counts the shading calls of [renderer] in another rendering of [sampled]. */
    fun shadingCalls(sampled: SampledFrame, renderer: Renderer): AovImage {
        val pixels = sampled.pixels
        val factor = sampled.sampling.factor
        val counts = AtomicIntegerArray(Math.toIntExact(pixels.size))
        val observer = ShadingObserver { x, y, _ ->
            val column = x / factor
            val row = y / factor
            if (pixels.contains(column, row)) {
                counts.incrementAndGet((row - pixels.rowStart) * pixels.width + column - pixels.columnStart)
            }
        }
        sampled.observed(observer).render(renderer) { _, _, _, _ -> }
        return AovImage(Aov.SHADING_CALLS, pixels, IntArray(counts.length()) { counts[it] }, samplesPerPixel(sampled))
    }
}

/**
 * Receives the rows of samples of [sampled], finds the sample of each pixel that wins the depth test, and computes
 * [aovs] there. Belongs to one rendering.
 */
internal class PointAovs(private val sampled: SampledFrame, private val aovs: List<Aov>) : RowSink {
    private val pixels = sampled.pixels
    private val factor = sampled.sampling.factor
    private val raster = sampled.frame.raster
    private val view = sampled.frame.content.view

    /** Distance of a pixel's first sample from the first sample of a row. */
    private val firstSample = pixels.columnStart * factor - sampled.frame.region.columnStart
    private val primitives = RecentPrimitives(sampled.frame.content)
    private val fragment = Fragment()
    private val needsGeometry = aovs.any { it == Aov.NORMAL || it == Aov.POSITION || it == Aov.UV }

    // The row of pixels that is in progress: key and place of each winner, and the number of covered samples
    private val keys = LongArray(pixels.width)
    private val columns = IntArray(pixels.width)
    private val rows = IntArray(pixels.width)
    private val covered = IntArray(pixels.width)

    private val size = if (aovs.isEmpty()) 0 else Math.toIntExact(pixels.size)
    private val floats = aovs.filter { !it.isInteger }.associateWith { FloatArray(size * it.channels.size) }
    private val objects = if (Aov.OBJECT in aovs) IntArray(size) else null
    private val indices = if (Aov.PRIMITIVE in aovs) IntArray(size) else null
    private val depths = floats[Aov.DEPTH]
    private val normals = floats[Aov.NORMAL]
    private val positions = floats[Aov.POSITION]
    private val uvs = floats[Aov.UV]
    private val coverage = floats[Aov.COVERAGE]

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        // A filter that is wider than a pixel has more rows
        val row = y / factor
        if (aovs.isEmpty() || row !in pixels.rowStart until pixels.rowEnd) return
        if (y % factor == 0) {
            keys.fill(Long.MAX_VALUE)
            covered.fill(0)
        }
        for (x in keys.indices) {
            val start = firstSample + x * factor
            for (i in start until start + factor) {
                if (primitive[i] != DepthTest.BACKGROUND) covered[x]++
                val key = raster.depthTest.key(depth[i], primitive[i])
                if (key >= keys[x]) continue
                keys[x] = key
                columns[x] = sampled.frame.region.columnStart + i
                rows[x] = y
            }
        }
        if (y % factor == factor - 1) for (x in keys.indices) end(x, (row - pixels.rowStart) * pixels.width + x)
    }

    /** Computes the numbers of the pixel in column [x] of the row, whose index in the image is [at]. */
    private fun end(x: Int, at: Int) {
        val index = raster.depthTest.indexOf(keys[x])
        val isCovered = index != DepthTest.BACKGROUND
        coverage?.set(at, covered[x].toFloat() / (factor * factor))
        indices?.set(at, index)
        objects?.set(at, if (isCovered) view.objectOf(index) else index)
        depths?.set(at, Float.POSITIVE_INFINITY)
        if (!isCovered || (depths == null && !needsGeometry)) return
        val primitive = primitives[index]
        if (depths != null) {
            fragment.moveTo(columns[x], rows[x])
            val unit = raster.convention.toUnit(raster.depthTest.depthOf(keys[x]))
            depths[at] = view.distance(unit, primitive, fragment).toFloat()
        }
        if (needsGeometry) {
            fragment.moveTo(columns[x], rows[x])
            primitive.geometry(fragment)
            store(at)
        }
    }

    private fun store(at: Int) {
        if (positions != null) {
            positions[3 * at] = (view.originX + fragment.worldX).toFloat()
            positions[3 * at + 1] = (view.originY + fragment.worldY).toFloat()
            positions[3 * at + 2] = (view.originZ + fragment.worldZ).toFloat()
        }
        if (normals != null) {
            val x = fragment.normalX.toDouble()
            val y = fragment.normalY.toDouble()
            val z = fragment.normalZ.toDouble()
            val length = StrictMath.sqrt(x * x + y * y + z * z)
            if (length > 0.0) {
                // A sum with 0 makes negative zeros positive
                normals[3 * at] = (x / length + 0.0).toFloat()
                normals[3 * at + 1] = (y / length + 0.0).toFloat()
                normals[3 * at + 2] = (z / length + 0.0).toFloat()
            }
        }
        if (uvs != null) {
            uvs[2 * at] = fragment.u
            uvs[2 * at + 1] = fragment.v
        }
    }

    /** Returns the images, without copying them. Call it once, after the last row. */
    fun images(): List<AovImage> = aovs.map { aov ->
        when (aov) {
            Aov.OBJECT -> AovImage(aov, pixels, objects!!, names = view.objectNames)
            Aov.PRIMITIVE -> AovImage(aov, pixels, indices!!)
            Aov.DEPTH -> AovImage(aov, pixels, depths!!, view.near, view.far)
            Aov.NORMAL -> AovImage(aov, pixels, normals!!, -1.0, 1.0)
            Aov.POSITION -> AovImage(aov, pixels, positions!!, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
            else -> AovImage(aov, pixels, floats.getValue(aov), 0.0, 1.0)
        }
    }
}

/** The primitives of [content] by submission index, without objects for all of them. Keeps recent ones; one thread. */
private class RecentPrimitives(content: FrameContent) {
    private val read = content.reader()

    /** Recent primitives, by the lower bits of their indices. */
    private val known = arrayOfNulls<Primitive>(KNOWN)
    private val indices = IntArray(KNOWN) { DepthTest.BACKGROUND }

    /** Returns the primitive with submission index [index], which is visible somewhere. */
    operator fun get(index: Int): Primitive {
        val slot = index and KNOWN - 1
        if (indices[slot] != index) {
            known[slot] = read(index)
            indices[slot] = index
        }
        return checkNotNull(known[slot])
    }

    private companion object {
        /** Number of primitives that are kept, a power of two. */
        const val KNOWN = 4096
    }
}
