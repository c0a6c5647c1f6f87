package dev.lazyz.strategies.tiled.raster

import jdk.incubator.vector.LongVector
import jdk.incubator.vector.VectorOperators
import jdk.incubator.vector.VectorSpecies

private val SPECIES: VectorSpecies<Long> =
    if (LongVector.SPECIES_PREFERRED.length() > BlockKernel.BLOCK) {
        LongVector.SPECIES_512
    } else {
        LongVector.SPECIES_PREFERRED
    }
private val LANES: Int = SPECIES.length()

/** Whether a vector holds only a part of a block's row. The block's farthest key may then be in another part. */
private val IS_PART: Boolean = LANES < BlockKernel.BLOCK

/**
 * Loops with the JVM's Vector API, which process a whole row of a block at a time with 512-bit registers. Can only be
 * loaded if the JVM has the module `jdk.incubator.vector`.
 *
 * Variables carried through a loop start with a loaded or computed value, never a constant vector, and methods are
 * small. C2 keeps vectors in registers only if both conditions are met.
 */
internal class VectorBlockKernel : BlockKernel {
    private lateinit var forms: TriangleForms

    // Steps from a block's first column to each column
    private val columns = LongArray(BlockKernel.BLOCK) { it.toLong() }
    private val e0 = LongArray(BlockKernel.BLOCK)
    private val e1 = LongArray(BlockKernel.BLOCK)
    private val e2 = LongArray(BlockKernel.BLOCK)
    private val z = LongArray(BlockKernel.BLOCK)

    override fun begin(forms: TriangleForms) {
        this.forms = forms
        for (i in 0 until BlockKernel.BLOCK) {
            e0[i] = i * forms.e0dx
            e1[i] = i * forms.e1dx
            e2[i] = i * forms.e2dx
            z[i] = i * forms.zdx
        }
    }

    override fun whole(keys: LongArray, at: Int, stride: Int, z: Long, farthest: LongArray, block: Int): Int {
        val before = farthest[block]
        var passes = 0
        var most = Long.MIN_VALUE
        var column = 0
        while (column < BlockKernel.BLOCK) {
            passes += wholeColumn(keys, at + column, stride, this.z, column, z, forms.zdy, forms.rank, farthest, block)
            most = maxOf(most, farthest[block])
            column += LANES
        }
        farthest[block] = if (passes > 0) most else before
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
        val before = farthest[block]
        var result = 0L
        var most = Long.MIN_VALUE
        var column = 0
        while (column < BlockKernel.BLOCK) {
            result += partColumn(keys, at + column, stride, column, e0, e1, e2, z, columns, rows, farthest, block)
            most = maxOf(most, farthest[block])
            column += LANES
        }
        farthest[block] = if (result.toInt() > 0) most else before
        return result
    }

    private fun partColumn(
        keys: LongArray,
        at: Int,
        stride: Int,
        column: Int,
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
        var v0 = LongVector.fromArray(SPECIES, this.e0, column).add(e0)
        var v1 = LongVector.fromArray(SPECIES, this.e1, column).add(e1)
        var v2 = LongVector.fromArray(SPECIES, this.e2, column).add(e2)
        var value = LongVector.fromArray(SPECIES, this.z, column).add(z)
        val exists = LongVector.fromArray(SPECIES, this.columns, column).compare(VectorOperators.LT, columns.toLong())
        var most = LongVector.fromArray(SPECIES, keys, at)
        var covered = 0
        var passes = 0
        var i = at
        val end = at + rows * stride
        while (i < end) {
            val old = LongVector.fromArray(SPECIES, keys, i)
            val key = value.and(BlockKernel.DEPTH_BITS).or(forms.rank)
            val inside = v0.or(v1).or(v2).compare(VectorOperators.GE, 0L).and(exists)
            val isNearer = key.compare(VectorOperators.LT, old).and(inside)
            val left = old.blend(key, isNearer)
            left.intoArray(keys, i)
            covered += inside.trueCount()
            passes += isNearer.trueCount()
            most = if (i == at) left else most.max(left)
            v0 = v0.add(forms.e0dy)
            v1 = v1.add(forms.e1dy)
            v2 = v2.add(forms.e2dy)
            value = value.add(forms.zdy)
            i += stride
        }
        if (passes > 0 || IS_PART) farthest[block] = most.reduceLanes(VectorOperators.MAX)
        return covered.toLong() shl Int.SIZE_BITS or passes.toLong()
    }

    companion object {
        /** Whether vectors are wide enough to be useful. */
        val isUseful: Boolean get() = LANES >= 4

        @JvmStatic
        private fun wholeColumn(
            keys: LongArray,
            at: Int,
            stride: Int,
            steps: LongArray,
            column: Int,
            z: Long,
            dy: Long,
            rank: Long,
            farthest: LongArray,
            block: Int,
        ): Int {
            var value = LongVector.fromArray(SPECIES, steps, column).add(z)
            var most = LongVector.fromArray(SPECIES, keys, at)
            var passes = 0
            var i = at
            val end = at + BlockKernel.BLOCK * stride
            while (i < end) {
                val old = LongVector.fromArray(SPECIES, keys, i)
                val key = value.and(BlockKernel.DEPTH_BITS).or(rank)
                passes += key.compare(VectorOperators.LT, old).trueCount()
                val left = old.min(key)
                left.intoArray(keys, i)
                most = if (i == at) left else most.max(left)
                value = value.add(dy)
                i += stride
            }
            if (passes > 0 || IS_PART) farthest[block] = most.reduceLanes(VectorOperators.MAX)
            return passes
        }
    }
}
