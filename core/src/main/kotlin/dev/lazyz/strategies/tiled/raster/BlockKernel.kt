package dev.lazyz.strategies.tiled.raster

/**
 * Lowers the keys of one block, [BLOCK] x [BLOCK] samples, to those of a triangle: the inner loops of the tiles.
 *
 * All kernels give the same bits. Stateless but for scratch: belongs to one thread.
 */
internal interface BlockKernel {
    /** Prepares for the triangle in [forms]; to be called when its steps have changed. */
    fun begin(forms: TriangleForms)

    /**
     * Draws a block that the triangle covers wholly. Notes in [farthest] at [block] the greatest key that is left.
     *
     * @param keys rows of [stride] keys; the block's first is at [at]
     * @param z depth at the block's first sample, see [TriangleForms.z]
     * @return how many keys were lowered
     */
    fun whole(keys: LongArray, at: Int, stride: Int, z: Long, farthest: LongArray, block: Int): Int

    /**
     * As [whole], for a block of which the triangle covers a part, and of which only the first [columns] and [rows] are
     * samples of the picture. [e0], [e1], [e2] are the edge functions at the block's first sample.
     *
     * @return how many samples are covered, times 2^32, plus how many keys were lowered
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
        /** Samples at a side of a block. */
        const val BLOCK: Int = 8

        /** The upper half of a key, and of a form of depth. */
        const val DEPTH_BITS: Long = -1L shl Int.SIZE_BITS
    }
}
