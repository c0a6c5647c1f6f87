package dev.lazyz.aov

import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Primitive
import dev.lazyz.RecentPrimitives
import dev.lazyz.RowSink
import dev.lazyz.filter.SampledFrame

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
        depths?.set(at, distance(x, primitive))
        if (needsGeometry) {
            fragment.moveTo(columns[x], rows[x])
            primitive.geometry(fragment)
            store(at)
        }
    }

    /** Returns the distance of the winner in column [x], a sample of [primitive]. */
    private fun distance(x: Int, primitive: Primitive): Float {
        val form = primitive.depthForm
        if (form != null && form.dx == 0L && form.dy == 0L) {
            val distance = distanceOfPosition(x, primitive)
            if (!distance.isNaN()) return distance.toFloat()
        }
        return view.distance(raster.convention.toUnit(raster.depthTest.depthOf(keys[x]))).toFloat()
    }

    /**
     * Returns the distance of the position of [primitive], or NaN if it has none. Where the depth test uses a constant,
     * the primitive may be a sliver seen edge-on, whose true depth is not constant (contract rule 3.4).
     */
    private fun distanceOfPosition(x: Int, primitive: Primitive): Double {
        fragment.moveTo(columns[x], rows[x])
        fragment.worldX = Float.NaN
        primitive.geometry(fragment)
        return view.distance(fragment.worldX, fragment.worldY, fragment.worldZ)
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
