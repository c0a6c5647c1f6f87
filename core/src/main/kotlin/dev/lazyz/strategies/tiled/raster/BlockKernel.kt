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

/** Loops that run on any JVM. */
internal class ScalarBlockKernel : BlockKernel {
    private lateinit var forms: TriangleForms

    override fun begin(forms: TriangleForms) {
        this.forms = forms
    }

    override fun whole(keys: LongArray, at: Int, stride: Int, z: Long, farthest: LongArray, block: Int): Int {
        val dx = forms.zdx
        val rank = forms.rank
        var first = z
        var passes = 0
        var most = Long.MIN_VALUE
        for (row in 0 until BlockKernel.BLOCK) {
            var value = first
            val start = at + row * stride
            for (i in start until start + BlockKernel.BLOCK) {
                val old = keys[i]
                val key = (value and BlockKernel.DEPTH_BITS) or rank
                val left = minOf(key, old)
                keys[i] = left
                passes += ((key - old) ushr 63).toInt()
                most = maxOf(most, left)
                value += dx
            }
            first += forms.zdy
        }
        if (passes > 0) farthest[block] = most
        return passes
    }

    override fun part(
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
    ): Long {
        val forms = forms
        val rank = forms.rank
        var first0 = e0
        var first1 = e1
        var first2 = e2
        var firstZ = z
        var covered = 0
        var passes = 0
        var most = Long.MIN_VALUE
        for (row in 0 until rows) {
            var v0 = first0
            var v1 = first1
            var v2 = first2
            var value = firstZ
            val start = at + row * stride
            for (i in start until start + columns) {
                val old = keys[i]
                var left = old
                if (v0 or v1 or v2 >= 0) {
                    val key = (value and BlockKernel.DEPTH_BITS) or rank
                    covered++
                    if (key < old) {
                        left = key
                        keys[i] = key
                        passes++
                    }
                }
                most = maxOf(most, left)
                v0 += forms.e0dx
                v1 += forms.e1dx
                v2 += forms.e2dx
                value += forms.zdx
            }
            first0 += forms.e0dy
            first1 += forms.e1dy
            first2 += forms.e2dy
            firstZ += forms.zdy
        }
        if (passes > 0) farthest[block] = most
        return covered.toLong() shl Int.SIZE_BITS or passes.toLong()
    }
}
