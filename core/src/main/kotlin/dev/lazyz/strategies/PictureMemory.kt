package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Renderer

/** Measures the memory that a renderer keeps for a picture, to decide before the rendering whether it fits. */
public object PictureMemory {
    /** Side of the empty pictures with which a renderer is measured. It is the width of the largest tile. */
    private const val PROBE_SIDE = 512

    /**
     * Returns the bytes that [renderer] keeps for each sample of a picture: the growth of its peak when the height of
     * an empty picture doubles. 0 if it keeps no picture, or fails on these pictures; the rendering then reports the
     * error. What it needs for primitives, and for rows and tiles in work, comes in addition. Cost: two renderings of
     * empty pictures of at most 512 x 1024 samples.
     *
     * @throws InterruptedException if the calling thread is interrupted, and the renderer checks for it
     */
    @JvmStatic
    @Throws(InterruptedException::class)
    public fun bytesPerSample(renderer: Renderer): Long {
        if (Capability.CONSTANT_MEMORY in renderer.capabilities) return 0
        return try {
            (peakBytes(renderer, 2) - peakBytes(renderer, 1)) / (PROBE_SIDE * PROBE_SIDE)
        } catch (_: RuntimeException) {
            0
        }
    }

    private fun peakBytes(renderer: Renderer, heights: Int): Long {
        val empty = Frame(Raster(PROBE_SIDE, heights * PROBE_SIDE), emptyList())
        return renderer.render(empty) { _, _, _, _ -> }.peakBytes
    }
}
