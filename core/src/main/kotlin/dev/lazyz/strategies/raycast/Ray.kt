package dev.lazyz.strategies.raycast

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.BoxTree
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.sortKeys

/**
 * The line of sight through one sample, which meets the primitives of [tree] that cover the sample, from near to far,
 * until all others are behind what is opaque. It is moved from sample to sample, along a row from left to right.
 */
internal class Ray(frame: Frame, private val tree: BoxTree, private val counters: Counters.Builder) {
    private val test = frame.raster.depthTest
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val row = RowCoverage(frame, tree)

    /** A lower bound of the keys of all fragments of the primitives below each node. */
    private val nearestKeys: LongArray

    init {
        val order = VisibilityOrder(test)
        nearestKeys = tree.values({ order.nearestKey(frame.content, it) }, ::minOf)
    }

    var x: Int = 0
        private set
    var y: Int = 0
        private set

    /** The nearest opaque primitive of the sample and its key; null and the key of the background if there is none. */
    var backdrop: Primitive? = null
        private set
    var backdropKey: Long = 0
        private set

    /** The keys of the translucent fragments before it: the first [layerCount], from near to far. */
    var layers: LongArray = LongArray(INITIAL)
        private set
    var layerCount: Int = 0
        private set

    /** Number of nodes examined so far. */
    var looks: Long = 0
        private set

    /** The key of the visible fragment, or of the background. */
    val nearest: Long get() = if (layerCount > 0) layers[0] else backdropKey

    /** Bytes held. */
    val bytes: Long get() = tree.bytes + nearestKeys.bytes + layers.bytes + row.bytes

    /** Moves to the begin of row [y], the next one. */
    fun beginRow(y: Int) {
        this.y = y
        row.begin(y)
    }

    /** Finds what is visible at column [x], which is right of the one before. */
    fun cast(x: Int) {
        this.x = x
        backdrop = null
        backdropKey = backgroundKey
        layerCount = 0
        if (tree.size > 0) find(BoxTree.ROOT)
        val held = layerCount + if (backdrop == null) 0 else 1
        counters.peakSuspensions = maxOf(counters.peakSuspensions, held.toLong())
        if (layerCount > 0) sortLayers()
    }

    private fun find(node: Int) {
        looks++
        if (nearestKeys[node] >= backdropKey || !tree.contains(node, x, y)) return
        if (node >= tree.size) return meet(node)
        val left = 2 * node
        val nearer = if (nearestKeys[left] <= nearestKeys[left + 1]) left else left + 1
        find(nearer)
        find(nearer xor 1)
    }

    private fun meet(leaf: Int) {
        endIfInterrupted()
        val primitive = row.covering(leaf, x) ?: return
        counters.fragments++
        counters.depthEvaluations++
        val key = test.key(primitive.depth(x, y), tree.primitive(leaf))
        if (key >= backdropKey) return
        counters.depthPasses++
        if (primitive.isTranslucent) {
            if (layerCount == layers.size) layers = layers.copyOf(2 * layerCount)
            layers[layerCount++] = key
        } else {
            backdropKey = key
            backdrop = primitive
        }
    }

    /** Removes the layers that an opaque primitive hides, and sorts the others. */
    private fun sortLayers() {
        var kept = 0
        for (i in 0 until layerCount) if (layers[i] < backdropKey) layers[kept++] = layers[i]
        layerCount = kept
        layers.sortKeys(Checkpoint.CALLER, 0, kept)
    }

    private companion object {
        const val INITIAL = 16
    }
}

/**
 * What the primitives of [tree] cover of a row. Spans are computed when a sample first meets the primitive, and kept
 * for the rest of the row; the object of a mesh's triangle is kept for the next row, too.
 */
internal class RowCoverage(frame: Frame, private val tree: BoxTree) {
    private val read = frame.content.reader()
    private val spans = frame.region.spans()
    private val objectBytes = if (frame.content.batches.isEmpty()) 0L else HeapLayout.TRIANGLE

    /** The primitives that were met on a row. */
    private class Met {
        var leaves = IntArray(INITIAL)
        var primitives = arrayOfNulls<Primitive>(INITIAL)

        /** Where in [columns] the first span is that does not end before the current column. */
        var cursors = IntArray(INITIAL)
        var count = 0

        val bytes: Long get() = leaves.bytes + primitives.bytes + cursors.bytes

        fun add(leaf: Int, primitive: Primitive, cursor: Int): Int {
            if (count == leaves.size) {
                leaves = leaves.copyOf(2 * count)
                primitives = primitives.copyOf(2 * count)
                cursors = cursors.copyOf(2 * count)
            }
            leaves[count] = leaf
            primitives[count] = primitive
            cursors[count] = cursor
            return count++
        }
    }

    private var y = 0
    private var met = Met()
    private var before = Met()

    /** For each leaf, its number among those that were met on the last row on which it was. */
    private val numbers = IntArray(tree.size)

    /** Spans of this row: starts and ends, and a span behind all columns after those of a primitive. */
    private var columns = IntArray(INITIAL)
    private var used = 0

    /** Bytes held. */
    val bytes: Long
        get() = met.bytes + before.bytes + numbers.bytes + columns.bytes + spans.bytes +
            objectBytes * (met.count + before.count)

    /** Moves to row [y], the next one. */
    fun begin(y: Int) {
        this.y = y
        met = before.also { before = met }
        met.count = 0
        used = 0
    }

    /** Returns the primitive at a leaf if it covers column [x], otherwise null. On a row, columns must not decrease. */
    fun covering(leaf: Int, x: Int): Primitive? {
        val number = number(leaf)
        var at = met.cursors[number]
        while (columns[at + 1] <= x) at += 2
        met.cursors[number] = at
        return if (columns[at] <= x) met.primitives[number] else null
    }

    /** Returns the number of the primitive at a leaf among those that were met; adds it if it was not. */
    private fun number(leaf: Int): Int {
        val known = numbers[leaf - tree.size]
        if (met.has(known, leaf)) return known
        val primitive = if (before.has(known, leaf)) before.primitives[known]!! else read(tree.primitive(leaf))
        spans.clear()
        primitive.spans(y, spans)
        if (used + 2 * spans.count + 2 > columns.size) columns = columns.copyOf(2 * (used + 2 * spans.count + 2))
        val number = met.add(leaf, primitive, used)
        numbers[leaf - tree.size] = number
        for (i in 0 until spans.count) {
            columns[used++] = spans.start(i)
            columns[used++] = spans.end(i)
        }
        columns[used++] = Int.MAX_VALUE
        columns[used++] = Int.MAX_VALUE
        return number
    }

    private fun Met.has(number: Int, leaf: Int): Boolean = number < count && leaves[number] == leaf

    private companion object {
        const val INITIAL = 64
    }
}
