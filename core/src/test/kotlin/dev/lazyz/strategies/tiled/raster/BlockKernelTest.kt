package dev.lazyz.strategies.tiled.raster

import dev.lazyz.DepthTest
import dev.lazyz.strategies.tiled.Kernels
import java.math.BigInteger
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** All kernels draw a block as the definition does: one sample after the other, by [TriangleForms.keyAt]. */
class BlockKernelTest {
    private val random = Random(8)
    private var steep = 0
    private var lowered = 0

    @Test
    fun blocksAreDrawnSampleBySample() {
        for (kernels in listOf(Kernels.SCALAR, Kernels.best()).distinct()) {
            val kernel = kernels.blocks()
            steep = 0
            lowered = 0
            repeat(20_000) {
                val forms = forms()
                kernel.begin(forms)
                if (it % 4 == 0) whole(kernel, forms, "$kernels, $it") else part(kernel, forms, "$kernels, $it")
            }
            assertTrue(steep > 300 && lowered > 30_000) { "$kernels: $steep steep forms, $lowered keys" }
        }
    }

    private fun whole(kernel: BlockKernel, forms: TriangleForms, what: String) {
        val block = Block(forms, SIDE, SIDE) { _, _ -> true } ?: return
        val passes = kernel.whole(block.keys, Block.AT, Block.STRIDE, forms.z, block.farthest, 1)
        assertEquals(block.passes, passes) { what }
        check(block, forms, what)
    }

    private fun part(kernel: BlockKernel, forms: TriangleForms, what: String) {
        val columns = if (random.nextBoolean()) SIDE else 1 + random.nextInt(SIDE)
        val rows = if (random.nextBoolean()) SIDE else 1 + random.nextInt(SIDE)
        val block = Block(forms, columns, rows) { x, y ->
            val v0 = forms.e0 + forms.e0dx * x + forms.e0dy * y
            val v1 = forms.e1 + forms.e1dx * x + forms.e1dy * y
            val v2 = forms.e2 + forms.e2dx * x + forms.e2dy * y
            v0 >= 0 && v1 >= 0 && v2 >= 0
        } ?: return
        val result = kernel.part(
            block.keys, Block.AT, Block.STRIDE, forms.e0, forms.e1, forms.e2, forms.z, columns, rows, block.farthest, 1,
        )
        assertEquals((block.covered.toLong() shl 32) + block.passes, result) { what }
        check(block, forms, what)
    }

    private fun check(block: Block, forms: TriangleForms, what: String) {
        assertEquals(block.expected.toList(), block.keys.toList()) { what }
        assertEquals(listOf(-7L, block.expectedFarthest, -7L), block.farthest.toList()) { what }
        if (Math.abs(forms.zdx) > STEEP / 2 || Math.abs(forms.zdy) > STEEP / 2) steep++
        lowered += block.passes
    }

    /** Steps of depth up to the steepest, and edges of up to the length of the guard band's sides, near the block. */
    private fun forms(): TriangleForms = TriangleForms(DepthTest.LESS).apply {
        zdx = step(61)
        zdy = if (random.nextInt(4) == 0) 0 else step(61)
        z = if (random.nextInt(4) == 0) 0 else random.nextLong() ushr 1 + random.nextInt(40)
        rank = random.nextLong() ushr Int.SIZE_BITS + random.nextInt(8)
        e0dx = step(36)
        e0dy = step(36)
        e0 = near(e0dx, e0dy)
        e1dx = step(36)
        e1dy = step(36)
        e1 = near(e1dx, e1dy)
        e2dx = step(36)
        e2dy = step(36)
        e2 = near(e2dx, e2dy)
    }

    /** Returns a step of at most 2^[bits]. */
    private fun step(bits: Int): Long = when (random.nextInt(8)) {
        0 -> 0L
        1 -> 1L shl bits
        2 -> -(1L shl bits)
        else -> random.nextLong() shr 63 - random.nextInt(bits + 1)
    }

    /** Returns a value at the origin with which the edge often passes through a sample, or beside one. */
    private fun near(dx: Long, dy: Long): Long =
        random.nextInt(4) - 2L - dx * random.nextInt(SIDE) - dy * random.nextInt(SIDE)

    private companion object {
        const val SIDE = BlockKernel.BLOCK
        const val STEEP = 1L shl 61
    }

    /** A block of keys, with others around it that must not change, and what it is after drawing. */
    private class Block private constructor(val keys: LongArray, val columns: Int, val rows: Int) {
        val farthest = longArrayOf(-7, -7, -7)
        val expected = keys.copyOf()
        var covered = 0
        var passes = 0

        /** The bound of the keys before, which may be greater than all of them. */
        private var bound = 0L

        /** The bound after. All kernels leave it where they lower nothing, so that all reject the same blocks later. */
        val expectedFarthest: Long get() = if (passes > 0) most(expected) else bound

        private fun most(keys: LongArray): Long =
            (0 until SIDE * SIDE).maxOf { keys[AT + it / SIDE * STRIDE + it % SIDE] }

        companion object {
            const val STRIDE = SIDE + 3
            const val AT = STRIDE + 1

            /** Returns null if the depth of a covered sample is out of range, which is no legal form. */
            operator fun invoke(
                forms: TriangleForms,
                columns: Int,
                rows: Int,
                isCovered: (x: Int, y: Int) -> Boolean,
            ): Block? {
                val random = Random(forms.z xor forms.zdx)
                val block = Block(LongArray(STRIDE * (SIDE + 2)) { random.nextLong() ushr 1 }, columns, rows)
                for (y in 0 until SIDE) {
                    for (x in 0 until SIDE) {
                        val at = AT + y * STRIDE + x
                        val isInside = x < columns && y < rows
                        val isHit = isInside && isCovered(x, y)
                        if (isHit && !isLegal(forms, x, y)) return null
                        val key = forms.keyAt(x, y)
                        block.keys[at] = when {
                            // As in VisibilityBuffer: nothing is drawn outside the picture
                            !isInside -> Long.MIN_VALUE
                            !isHit -> block.keys[at]
                            random.nextInt(4) == 0 -> Long.MAX_VALUE
                            random.nextInt(4) == 0 -> key
                            random.nextInt(4) == 0 -> maxOf(key - 1, 0)
                            else -> block.keys[at]
                        }
                        block.expected[at] = block.keys[at]
                        if (!isHit) continue
                        block.covered++
                        if (key < block.keys[at]) block.passes++
                        block.expected[at] = minOf(key, block.keys[at])
                    }
                }
                block.bound = if (random.nextBoolean()) Long.MAX_VALUE else block.most(block.keys)
                block.farthest[1] = block.bound
                return block
            }

            private fun isLegal(forms: TriangleForms, x: Int, y: Int): Boolean {
                fun big(a: Long, b: Int) = BigInteger.valueOf(a) * BigInteger.valueOf(b.toLong())
                val depth = big(forms.z, 1) + big(forms.zdx, x) + big(forms.zdy, y)
                return depth.signum() >= 0 && depth.bitLength() < Long.SIZE_BITS
            }
        }
    }
}
