package dev.lazyz.strategies.painter

import dev.lazyz.Checkpoint
import dev.lazyz.Frame
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
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
    private val tree = UnpaintedTree(IntArray(byDepth.size) { test.indexOf(byDepth[it]) }, frame, pairs)
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
 * nearest fragment.
 *
 * A complete binary tree over the primitives, sorted by the centres of their boxes along a Z-order curve. A node holds
 * the bounding box of all primitives below it, and the farthest key of those that are not yet painted.
 *
 * Source of the curve: Guy Morton, "A computer oriented geodetic data base and a new technique in file sequencing"
 * (1966).
 */
internal class UnpaintedTree(indices: IntArray, private val frame: Frame, private val pairs: PairOrder) {
    private val region = frame.region
    private val leaves = maxOf(Integer.highestOneBit(maxOf(indices.size, 1) * 2 - 1), 1)

    /** Index of the primitive at each leaf, and the leaf of each primitive. */
    private val primitives = IntArray(leaves)
    private val leafOf = IntArray(frame.primitives.size)

    /**
     * Columns and rows of each node's box, four numbers; node 1 is the root, nodes 2n and 2n+1 are the children of n.
     */
    private val boxes = IntArray(4 * 2 * leaves)
    private val farthest = LongArray(2 * leaves) { NOTHING }

    /** Number of nodes examined so far. */
    var looks: Long = 0
        private set

    /** Bytes held. */
    val bytes: Long get() = primitives.bytes + leafOf.bytes + boxes.bytes + farthest.bytes

    init {
        // Sort the leaves along the curve
        val curve = LongArray(indices.size) { place(indices[it]) or indices[it].toLong() }
        curve.sortKeys(Checkpoint.CALLER)
        for (leaf in curve.indices) {
            endIfInterrupted()
            val index = (curve[leaf] and Int.MAX_VALUE.toLong()).toInt()
            val primitive = frame.primitives[index]
            primitives[leaf] = index
            leafOf[index] = leaf
            val node = leaves + leaf
            boxes[4 * node] = primitive.columnStart
            boxes[4 * node + 1] = primitive.columnEnd
            boxes[4 * node + 2] = primitive.rowStart
            boxes[4 * node + 3] = primitive.rowEnd
            farthest[node] = pairs.farthestKey(index)
        }

        // Compute the inner nodes from the bottom up
        for (node in leaves - 1 downTo 1) {
            endIfInterrupted()
            val left = 4 * (2 * node)
            val right = left + 4
            if (farthest[2 * node + 1] == NOTHING) {
                boxes.copyInto(boxes, 4 * node, left, left + 4)
            } else {
                for (side in 0 until 4 step 2) {
                    boxes[4 * node + side] = minOf(boxes[left + side], boxes[right + side])
                    boxes[4 * node + side + 1] = maxOf(boxes[left + side + 1], boxes[right + side + 1])
                }
            }
            farthest[node] = maxOf(farthest[2 * node], farthest[2 * node + 1])
        }
    }

    /** Removes the primitive [index]. Returns false if it was already removed. */
    fun remove(index: Int): Boolean {
        var node = leaves + leafOf[index]
        if (farthest[node] == NOTHING) return false
        farthest[node] = NOTHING
        while (node > ROOT) {
            node /= 2
            farthest[node] = maxOf(farthest[2 * node], farthest[2 * node + 1])
        }
        return true
    }

    /** Calls [found] with each primitive that may share samples with the primitive [index] and be behind it there. */
    fun find(index: Int, found: IntConsumer) {
        find(ROOT, index, pairs.nearestKey(index), found)
    }

    private fun find(node: Int, index: Int, nearest: Long, found: IntConsumer) {
        looks++
        if (farthest[node] <= nearest || !overlaps(node, index)) return
        if (node >= leaves) {
            found.accept(primitives[node - leaves])
        } else {
            find(2 * node, index, nearest, found)
            find(2 * node + 1, index, nearest, found)
        }
    }

    private fun overlaps(node: Int, index: Int): Boolean {
        val primitive = frame.primitives[index]
        return boxes[4 * node] < primitive.columnEnd && primitive.columnStart < boxes[4 * node + 1] &&
            boxes[4 * node + 2] < primitive.rowEnd && primitive.rowStart < boxes[4 * node + 3]
    }

    /**
     * Position of a box's centre on the curve: the bits of column and row (16 each) interleaved, shifted left by the 31
     * bits of an index.
     */
    private fun place(index: Int): Long {
        endIfInterrupted()
        val primitive = frame.primitives[index]
        val column = middle(primitive.columnStart, primitive.columnEnd, region.columnStart, region.columnEnd)
        val row = middle(primitive.rowStart, primitive.rowEnd, region.rowStart, region.rowEnd)
        return (spread(column) or (spread(row) shl 1)) shl 31
    }

    /** The middle of the part of a range that lies within another range, scaled to 16 bits. */
    private fun middle(start: Int, end: Int, least: Int, most: Int): Int {
        val doubled = maxOf(start, least) + minOf(end, most) - 2 * least
        return (doubled * CURVE_STEPS / (2 * (most - least))).toInt()
    }

    /** Inserts a 0 before each of 16 bits. */
    private fun spread(bits: Int): Long {
        var spread = 0L
        for (bit in 0 until 16) spread = spread or ((bits shr bit and 1).toLong() shl (2 * bit))
        return spread
    }

    private companion object {
        const val ROOT = 1
        const val NOTHING = Long.MIN_VALUE
        const val CURVE_STEPS = 65535L
    }
}
