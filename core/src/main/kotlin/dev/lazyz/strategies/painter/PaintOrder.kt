package dev.lazyz.strategies.painter

import dev.lazyz.Checkpoint
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.BoxTree
import dev.lazyz.raster.forEachPrimitive
import dev.lazyz.raster.reaches
import dev.lazyz.raster.sortKeys
import java.util.function.IntConsumer

/**
 * An order of painting: from back to front by greatest depth, corrected by Newell's tests.
 *
 * Before a primitive is painted, all primitives that may share samples with it and are proved to be behind it are
 * painted, and before each of those the primitives behind it, and so on. A primitive that this search reaches a second
 * time is part of a cycle and is not moved. Where no order is proved, the order of depth remains.
 *
 * The pairs to test are found with a tree over the primitives that are not yet painted, so small primitives cost O(log
 * n) each. If very many boxes overlap on the screen and in depth, the search ends after [LOOKS_PER_PRIMITIVE] nodes a
 * primitive, on average; the rest is painted by greatest depth. This limit does not affect the picture, only the number
 * of samples that are compared.
 *
 * Source: Newell, Newell, Sancha, "A Solution to the Hidden Surface Problem" (1972). In the paper, one primitive at a
 * time is moved to the head of the list and marked; here the search is depth first.
 */
internal class PaintOrder(private val frame: Frame, private val pairs: PairOrder) {
    private val test = frame.raster.depthTest
    private val region = frame.region

    /** Farthest keys of the primitives that reach the region, from back to front. A key also holds the index. */
    private val byDepth = byDepth()
    private val tree = UnpaintedTree(frame, pairs)
    private val budget = LOOKS_PER_PRIMITIVE * byDepth.size

    /** Primitives to paint next: an index must still be examined, the complement of an index only painted. */
    private var stack = IntArray(16)
    private var height = 0

    /** Bytes held. */
    val bytes: Long get() = byDepth.bytes + stack.bytes + tree.bytes

    /** Number of nodes of the tree examined so far. */
    val looks: Long get() = tree.looks

    /** Calls [paint] with each primitive that may cover a sample, in order. Can be called once. */
    fun forEach(paint: IntConsumer) {
        for (key in byDepth) {
            push(test.indexOf(key))
            while (height > 0) {
                endIfInterrupted()
                val next = stack[--height]
                if (next < 0) {
                    paint.accept(next.inv())
                } else if (tree.remove(next)) {
                    // Paint it after all its predecessors are painted
                    push(next.inv())
                    pushPredecessors(next)
                }
            }
        }
    }

    private fun pushPredecessors(index: Int) {
        if (looks > budget) return
        tree.find(index) { other ->
            endIfInterrupted()
            if (mustPrecede(other, index)) push(other)
        }
    }

    /** Newell's tests: whether [other] must be painted before [index], that is, is proved to be behind it. */
    private fun mustPrecede(other: Int, index: Int): Boolean =
        !pairs.isBefore(other, index) && !pairs.isApart(other, index) && pairs.isBefore(index, other)

    private fun push(entry: Int) {
        if (height == stack.size) stack = stack.copyOf(2 * height)
        stack[height++] = entry
    }

    private fun byDepth(): LongArray {
        val keys = LongArray(frame.primitives.size)
        var used = 0
        frame.forEachPrimitive(Checkpoint.CALLER) { index, primitive ->
            if (primitive.reaches(region)) keys[used++] = pairs.farthestKey(index)
        }
        return keys.copyOf(used).apply {
            sortKeys(Checkpoint.CALLER)
            reverse()
        }
    }

    companion object {
        /** Most nodes of the tree that are examined a primitive, on average: enough for about 500 overlapping pairs. */
        const val LOOKS_PER_PRIMITIVE: Long = 1024
    }
}

/**
 * Finds primitives that are not yet painted, overlap a given primitive's box on the screen, and may be behind its
 * nearest fragment. A node of the tree holds the farthest key of those below it that are not yet painted.
 */
internal class UnpaintedTree(private val frame: Frame, private val pairs: PairOrder) {
    private val boxes = BoxTree(frame)
    private val farthest = boxes.values(pairs::farthestKey, ::maxOf)

    /** The leaf of each primitive that reaches the region. */
    private val leafOf = IntArray(frame.primitives.size)

    /** Number of nodes examined so far. */
    var looks: Long = 0
        private set

    /** Bytes held. */
    val bytes: Long get() = boxes.bytes + farthest.bytes + leafOf.bytes

    init {
        for (leaf in boxes.size until 2 * boxes.size) leafOf[boxes.primitive(leaf)] = leaf
    }

    /** Removes the primitive [index]. Returns false if it was already removed. */
    fun remove(index: Int): Boolean {
        var node = leafOf[index]
        if (farthest[node] == NOTHING) return false
        farthest[node] = NOTHING
        while (node > BoxTree.ROOT) {
            node /= 2
            farthest[node] = maxOf(farthest[2 * node], farthest[2 * node + 1])
        }
        return true
    }

    /** Calls [found] with each primitive that may share samples with the primitive [index] and be behind it there. */
    fun find(index: Int, found: IntConsumer) {
        find(BoxTree.ROOT, frame.primitives[index], pairs.nearestKey(index), found)
    }

    private fun find(node: Int, near: Primitive, nearest: Long, found: IntConsumer) {
        looks++
        if (farthest[node] <= nearest) return
        if (!boxes.overlaps(node, near.columnStart, near.rowStart, near.columnEnd, near.rowEnd)) return
        if (node >= boxes.size) {
            found.accept(boxes.primitive(node))
        } else {
            find(2 * node, near, nearest, found)
            find(2 * node + 1, near, nearest, found)
        }
    }

    private companion object {
        const val NOTHING = Long.MIN_VALUE
    }
}
