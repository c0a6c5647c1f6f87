package dev.lazyz.raster

import dev.lazyz.Checkpoint
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.forEachIn

/**
 * The primitives that reach a frame's region, in a binary tree of boxes on the screen: a bounding volume hierarchy.
 *
 * They are the leaves, sorted by the centres of their boxes along a Z-order curve; the box of any other node contains
 * those of the nodes below it. Node [ROOT] is the root, if there are primitives. Nodes 2n and 2n + 1 are below node n.
 * Nodes from [size] on are leaves. Makes no objects of the triangles of meshes.
 *
 * Memory: 36 bytes a primitive, and 8 more while it is made. Ends if the calling thread is interrupted.
 *
 * Source of the curve: Guy Morton, "A computer oriented geodetic data base and a new technique in file sequencing"
 * (1966).
 */
internal class BoxTree(frame: Frame) {
    private val region = frame.region

    /** Number of primitives. */
    val size: Int

    /** Submission index of the primitive at each leaf. */
    private val indices: IntArray

    /** Columns and rows of each node's box, within the region: four numbers, the ends exclusive. */
    private val boxes: IntArray

    /** Bytes held. */
    val bytes: Long get() = indices.bytes + boxes.bytes

    init {
        // Sort the leaves along the curve
        val content = frame.content
        var count = 0
        content.forEachIn(region) { _, _ -> count++ }
        size = count
        val curve = LongArray(size)
        content.forEachIn(region) { index, box -> curve[--count] = place(box) or index.toLong() }
        curve.sortKeys(Checkpoint.CALLER)
        indices = IntArray(size) { (curve[it] and INDEX).toInt() }

        // Compute the boxes from the bottom up
        boxes = IntArray(SIDES * 2 * size)
        for (leaf in 0 until size) {
            endIfInterrupted()
            val box = checkNotNull(content.boundsIn(region, indices[leaf]))
            val at = SIDES * (size + leaf)
            boxes[at] = box.columnStart
            boxes[at + 1] = box.rowStart
            boxes[at + 2] = box.columnEnd
            boxes[at + 3] = box.rowEnd
        }
        for (node in size - 1 downTo ROOT) {
            val at = SIDES * node
            val left = 2 * at
            val right = left + SIDES
            boxes[at] = minOf(boxes[left], boxes[right])
            boxes[at + 1] = minOf(boxes[left + 1], boxes[right + 1])
            boxes[at + 2] = maxOf(boxes[left + 2], boxes[right + 2])
            boxes[at + 3] = maxOf(boxes[left + 3], boxes[right + 3])
        }
    }

    /** Returns a value for each node: that of a leaf by the index of its primitive, others by the two nodes below. */
    inline fun values(ofPrimitive: (index: Int) -> Long, ofBoth: (Long, Long) -> Long): LongArray {
        val values = LongArray(2 * size)
        for (leaf in size until 2 * size) {
            endIfInterrupted()
            values[leaf] = ofPrimitive(primitive(leaf))
        }
        for (node in size - 1 downTo ROOT) values[node] = ofBoth(values[2 * node], values[2 * node + 1])
        return values
    }

    /** Returns the submission index of the primitive at a leaf. */
    fun primitive(leaf: Int): Int = indices[leaf - size]

    /** Whether the box of [node] contains a sample. */
    fun contains(node: Int, x: Int, y: Int): Boolean {
        val at = SIDES * node
        return x >= boxes[at] && y >= boxes[at + 1] && x < boxes[at + 2] && y < boxes[at + 3]
    }

    /** Whether the box of [node] shares samples with these columns and rows, the ends exclusive. */
    fun overlaps(node: Int, columnStart: Int, rowStart: Int, columnEnd: Int, rowEnd: Int): Boolean {
        val at = SIDES * node
        return boxes[at] < columnEnd && boxes[at + 1] < rowEnd && columnStart < boxes[at + 2] &&
            rowStart < boxes[at + 3]
    }

    /**
     * Position of a box's centre on the curve: the bits of column and row (16 each) interleaved, shifted left by the 31
     * bits of an index.
     */
    private fun place(box: Region): Long {
        val column = middle(box.columnStart, box.columnEnd, region.columnStart, region.width)
        val row = middle(box.rowStart, box.rowEnd, region.rowStart, region.height)
        return (spread(column) or (spread(row) shl 1)) shl Int.SIZE_BITS - 1
    }

    /** The middle of a range in the range of [length] from [first] on, scaled to 16 bits. */
    private fun middle(start: Int, end: Int, first: Int, length: Int): Int =
        ((start + end - 2 * first) * CURVE_STEPS / (2 * length)).toInt()

    /** Inserts a 0 before each of 16 bits. */
    private fun spread(bits: Int): Long {
        var spread = 0L
        for (bit in 0 until 16) spread = spread or ((bits shr bit and 1).toLong() shl (2 * bit))
        return spread
    }

    companion object {
        const val ROOT: Int = 1

        /** Numbers of a box. */
        private const val SIDES = 4

        private const val CURVE_STEPS = 65535L
        private const val INDEX = Int.MAX_VALUE.toLong()
    }
}
