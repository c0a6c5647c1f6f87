package dev.lazyz.strategies.raycast

import dev.lazyz.Blending
import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.BoxTree
import dev.lazyz.requireInMemory
import dev.lazyz.shading.LateShading
import java.io.IOException

/**
 * One sample after the other: the primitives that may be visible there are found in a hierarchy of boxes.
 *
 * Other renderers take a primitive and look for its samples; this one takes a sample and looks for its primitives. It
 * goes through a tree of boxes from near to far, and leaves out each box that does not contain the sample, or is behind
 * what was found so far. So the work for a sample grows with the logarithm of the number of primitives, and hardly with
 * the layers that are hidden. This is primary visibility alone: no ray is reflected or casts a shadow. A sample where
 * translucent primitives are before the visible opaque one sorts and blends them.
 *
 * Use it for a few samples of a large scene, such as picking or thumbnails of regions; triangles of meshes that no
 * sample meets never become objects. For whole pictures of small triangles, other renderers find many samples with one
 * search.
 *
 * Memory: 52 bytes a primitive, and 8 more while they are sorted; for a row, 20 bytes for each primitive that a sample
 * met, its spans, and, of meshes, its object. Time: for n primitives O(n log n) to sort them, and O(log n) for a sample
 * where boxes overlap little; a primitive's spans once for each row on which a sample meets its box. Thread safe; no
 * state between calls.
 *
 * Source: Arthur Appel, "Some techniques for shading machine renderings of solids", AFIPS Spring Joint Computer
 * Conference 32 (1968), casts a ray for each sample; Steven Rubin, Turner Whitted, "A 3-dimensional representation for
 * fast rendering of complex scenes", SIGGRAPH 1980, for the hierarchy. There, rays and boxes are in the space of the
 * scene; here they are on the screen, where a ray is a sample and all is exact.
 *
 * @param options only [RenderOptions.coherence] is used
 */
public class RaycastRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) :
    Renderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "raycast"

    override val summary: String get() = "one sample at a time, its primitives found in a hierarchy of boxes"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.CONSTANT_MEMORY,
            Capability.STREAMS_ROWS,
            Capability.TRANSPARENCY,
            Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): Renderer = RaycastRenderer(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireInMemory(frame, this)
        val counters = Counters.Builder()
        counters.primitives = frame.content.size.toLong()
        val region = frame.region
        val test = frame.raster.depthTest
        val ray = Ray(frame, BoxTree(frame), counters)
        val colors = RayColors(frame, LateShading(frame, options.coherence, counters, Checkpoint.CALLER))
        val argb = IntArray(region.width)
        val depths = IntArray(region.width)
        val indices = IntArray(region.width)
        for (y in region.rowStart until region.rowEnd) {
            ray.beginRow(y)
            colors.beginRow()
            for (i in 0 until region.width) {
                endIfInterrupted()
                ray.cast(region.columnStart + i)
                argb[i] = colors.of(ray)
                depths[i] = test.depthOf(ray.nearest)
                indices[i] = test.indexOf(ray.nearest)
            }
            counters.peakBytes = maxOf(counters.peakBytes, ray.bytes)
            sink.row(y, argb, depths, indices)
        }
        counters.peakBytes += argb.bytes + depths.bytes + indices.bytes + colors.peakBytes
        return counters.build()
    }

    override fun toString(): String = "RaycastRenderer($options)"
}

/** Computes the colour of what a [Ray] has met. */
private class RayColors(private val frame: Frame, private val shading: LateShading) {
    private val test = frame.raster.depthTest
    private val background = frame.raster.background.toArgb()
    private val blending = Blending()

    val peakBytes: Long get() = shading.peakBytes

    fun beginRow(): Unit = shading.beginRow()

    fun of(ray: Ray): Int {
        val backdrop = ray.backdrop
        if (ray.layerCount == 0) {
            if (backdrop == null) return background
            return shading.shaded(ray.x, ray.y, test.indexOf(ray.backdropKey), backdrop).toArgb()
        }
        return blending.blend(ray.layerCount, backdrop != null, frame.raster.background) { i ->
            val key = if (i < ray.layerCount) ray.layers[i] else ray.backdropKey
            val index = test.indexOf(key)

            // Translucent primitives are in no batch
            val primitive = if (i < ray.layerCount) frame.content.single(index) else checkNotNull(backdrop)
            shading.shaded(ray.x, ray.y, index, primitive)
        }
    }
}
