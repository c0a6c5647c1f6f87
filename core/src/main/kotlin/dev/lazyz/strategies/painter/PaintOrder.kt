package dev.lazyz.strategies.painter

import dev.lazyz.Frame
import dev.lazyz.raster.reaches
import java.util.function.IntConsumer

/**
 * An order of painting: from back to front by greatest depth, mended by Newell's tests.
 *
 * Before a primitive is painted, all that is proved to be behind it and may share samples with it is painted, and
 * before that what is behind those, and so on. What is met a second time on this way lies in a circle; it waits. What
 * nothing is proved for stays in the order of depth.
 *
 * The pairs to test are found by a tree over what is not yet painted, so small primitives cost O(log n) each. Where
 * very many boxes overlap on the screen and in depth, the search ends after [LOOKS_PER_PRIMITIVE] looks a primitive,
 * on average; the rest is painted by greatest depth. The picture does not depend on it, only how many samples are
 * compared.
 *
 * Source: Newell, Newell, Sancha, "A Solution to the Hidden Surface Problem" (1972). There one primitive at a time is
 * moved to the head of the list, and marked; here the way back is walked depth first.
 */
internal class PaintOrder(private val frame: Frame, private val pairs: PairOrder) {
    private val test = frame.raster.depthTest
    private val region = frame.region

    /** Farthest keys of what covers samples, from back to front. A key also holds the index. */
    private val byDepth = byDepth()
    private val tree = UnpaintedTree(IntArray(byDepth.size) { test.indexOf(byDepth[it]) }, frame, pairs)
    private val budget = LOOKS_PER_PRIMITIVE * byDepth.size

    /** Primitives to paint next: an index is still to be looked at, the complement of one only to be painted. */
    private var stack = IntArray(16)
    private var height = 0

    /** Bytes held. */
    val bytes: Long get() = 8L * byDepth.size + 4L * stack.size + tree.bytes

    /** Number of nodes of the tree that were looked at so far. */
    val looks: Long get() = tree.looks

    /** Calls [paint] with each primitive that may cover a sample, in order. To be called once. */
    fun forEach(paint: IntConsumer) {
        for (key in byDepth) {
            push(test.indexOf(key))
            while (height > 0) {
                val next = stack[--height]
                if (next < 0) {
                    paint.accept(next.inv())
                } else if (tree.remove(next)) {
                    // Paint it when all that must come before is painted
                    push(next.inv())
                    pushPredecessors(next)
                }
            }
        }
    }

    private fun pushPredecessors(index: Int) {
        if (looks > budget) return
        tree.find(index) { other -> if (mustPrecede(other, index)) push(other) }
    }

    /** Newell's tests: nothing speaks against painting [index] first, or the [other] is behind it, or neither. */
    private fun mustPrecede(other: Int, index: Int): Boolean =
        !pairs.isBefore(other, index) && !pairs.isApart(other, index) && pairs.isBefore(index, other)

    private fun push(entry: Int) {
        if (height == stack.size) stack = stack.copyOf(2 * height)
        stack[height++] = entry
    }

    private fun byDepth(): LongArray {
        val keys = LongArray(frame.primitives.size)
        var used = 0
        for ((index, primitive) in frame.primitives.withIndex()) {
            if (primitive.reaches(region)) keys[used++] = pairs.farthestKey(index)
        }
        return keys.copyOf(used).apply {
            sort()
            reverse()
        }
    }

    companion object {
        /** Nodes of the tree that are looked at, a primitive, on average, at most: some 500 overlapping pairs. */
        const val LOOKS_PER_PRIMITIVE: Long = 1024
    }
}
