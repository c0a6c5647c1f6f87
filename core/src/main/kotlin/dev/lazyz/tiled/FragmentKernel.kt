package dev.lazyz.tiled

import dev.lazyz.FragmentBatch
import dev.lazyz.setup.Face

/**
 * What is done for every visible sample, before and after it is shaded: the loops of [TileShading].
 *
 * All kernels give the same bits. Stateless but for scratch: belongs to one thread.
 */
internal interface FragmentKernel {
    /**
     * Fills in the attributes of [face] at the samples [x] until [x] + [count] of row [y], from place [at] of [batch] on.
     * What stands behind these places, as far as [FragmentBatch.SPARE] further, may be overwritten.
     */
    fun attributes(face: Face, batch: FragmentBatch, at: Int, x: Int, y: Int, count: Int)

    /** Packs the colours of [batch] into [argb], which has room for [FragmentBatch.SPARE] more. */
    fun pack(batch: FragmentBatch, argb: IntArray)
}
