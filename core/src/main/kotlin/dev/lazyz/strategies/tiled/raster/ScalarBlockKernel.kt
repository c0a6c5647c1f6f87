package dev.lazyz.strategies.tiled.raster

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
