package dev.lazyz.strategies.tiled.raster

/**
 * Replaces the keys of one block, [BLOCK] x [BLOCK] samples, with those of a triangle where the latter are less: the
 * inner loops of the tiles.
 *
 * All kernels give the same bits and the same counts. No state except scratch memory; belongs to one thread.
 */
internal interface BlockKernel {
    /** Prepares for the triangle in [forms]; must be called when its steps have changed. */
    fun begin(forms: TriangleForms)

    /**
     * Draws a block that the triangle covers completely. If a key was lowered, stores the greatest resulting key in
     * [farthest] at [block].
     *
     * @param keys rows of [stride] keys; the block's first key is at [at]
     * @param z depth at the block's first sample, see [TriangleForms.z]
     * @return number of keys that were lowered
     */
    fun whole(keys: LongArray, at: Int, stride: Int, z: Long, farthest: LongArray, block: Int): Int

    /**
     * Like [whole], for a block that the triangle covers partly, or of which only the first [columns] and [rows] are
     * within the picture. [e0], [e1], [e2] are the edge functions at the block's first sample.
     *
     * @return number of covered samples, times 2^32, plus the number of keys that were lowered
     */
    fun part(
        keys: LongArray,
        at: Int,
        stride: Int,
        e0: Long,
        e1: Long,
        e2: Long,
        z: Long,
        columns: Int,
        rows: Int,
        farthest: LongArray,
        block: Int,
    ): Long

    companion object {
        /** Samples along a side of a block. */
        const val BLOCK: Int = 8

        /** The upper half of a key, and of a depth form. */
        const val DEPTH_BITS: Long = -1L shl Int.SIZE_BITS
    }
}
