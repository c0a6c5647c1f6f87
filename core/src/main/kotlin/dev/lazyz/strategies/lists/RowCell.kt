package dev.lazyz.strategies.lists

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.Selector.Cell
import dev.lazyz.bytes
import dev.lazyz.raster.sortKeys
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Srgb

/** The cell of one sample of the current row. It is moved from sample to sample, from left to right. */
internal class RowCell(
    private val frame: Frame,
    private val fragments: RowFragments,
    private val shading: LateShading,
) : Cell {
    private val test = frame.raster.depthTest
    private var start = 0
    private var end = 0
    private var isLeastFirst = false
    private var isSorted = false

    override var x: Int = 0
        private set
    override var y: Int = 0
        private set

    /** Number of the fragment that is shown, or -1. */
    private var shown = -1

    /** The colour that is shown. */
    var argb: Int = 0
        private set

    /** Whether a fragment is shown. */
    val isShown: Boolean get() = shown >= 0

    /** The depth that is shown. */
    val shownDepth: Int get() = depth(shown)

    /** The primitive that is shown. */
    val shownPrimitive: Int get() = primitive(shown)

    override val size: Int get() = end - start

    override val background: Rgba get() = frame.raster.background

    /** Moves to a [column] of the region; returns whether it has fragments. */
    fun moveTo(column: Int, y: Int): Boolean {
        x = frame.region.columnStart + column
        this.y = y
        start = fragments.start(column)
        end = fragments.end(column)
        isLeastFirst = false
        isSorted = false
        shown = -1
        return start < end
    }

    override fun depth(i: Int): Int = test.depthOf(key(i))

    override fun primitive(i: Int): Int = test.indexOf(key(i))

    override fun isTranslucent(i: Int): Boolean = primitiveAt(i).isTranslucent

    override fun shade(i: Int): Fragment = shading.shaded(x, y, primitive(i), primitiveAt(i))

    override fun show(i: Int) {
        argb = shade(i).toArgb()
        shown = i
    }

    override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) {
        checkNumber(i)
        argb = Srgb.pack(red, green, blue, alpha)
        shown = i
    }

    private fun primitiveAt(i: Int): Primitive = frame.primitives[primitive(i)]

    private fun key(i: Int): Long {
        checkNumber(i)
        if (i == 0) bringLeastToFront() else sort()
        return fragments.keys[start + i]
    }

    private fun checkNumber(i: Int) {
        require(i in 0 until size) { "fragment must be in 0..${size - 1}: $i" }
    }

    private fun sort() {
        if (!isSorted) fragments.keys.sortKeys(Checkpoint.CALLER, start, end)
        isSorted = true
    }

    /** Finds the nearest fragment, which takes a minimum instead of a sort. */
    private fun bringLeastToFront() {
        if (isSorted || isLeastFirst) return
        val keys = fragments.keys
        var least = start
        for (at in start + 1 until end) if (keys[at] < keys[least]) least = at
        val key = keys[least]
        keys[least] = keys[start]
        keys[start] = key
        isLeastFirst = true
    }

    override fun toString(): String = "Cell($x, $y, $size fragments)"
}

/** The row that is passed to the sink. */
internal class RowOutput(frame: Frame) {
    private val raster = frame.raster
    private val background = raster.background.toArgb()
    private val argb = IntArray(frame.width)
    private val depths = IntArray(frame.width)
    private val indices = IntArray(frame.width)

    /** Bytes held. */
    val bytes: Long get() = argb.bytes + depths.bytes + indices.bytes

    fun clear() {
        argb.fill(background)
        depths.fill(raster.backgroundDepth)
        indices.fill(DepthTest.BACKGROUND)
    }

    fun set(column: Int, cell: RowCell) {
        argb[column] = cell.argb
        depths[column] = cell.shownDepth
        indices[column] = cell.shownPrimitive
    }

    fun handOut(y: Int, sink: RowSink) {
        sink.row(y, argb, depths, indices)
    }
}
