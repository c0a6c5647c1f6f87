package dev.lazyz.conformance.strangers4

import dev.lazyz.Cell
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Rgba
import dev.lazyz.Selector

/** Chooses, for each sample of a row, what its fragments show: by a selector, or as rules 5.1 and 5.5 say. */
internal class ListChoice(
    private val frame: Frame,
    private val band: ListBand,
    private val selector: Selector?,
    private val counters: Counters.Builder,
    private val mistake: Mistake?,
) {
    private val test = frame.raster.depthTest
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val backgroundColor = frame.raster.background.toArgb()
    private val blender = Blender(mistake)
    private val fragment = Fragment()
    private val result = Fragment()
    private val cell = SampleCell()
    private var keys = LongArray(16)
    private var size = 0

    val argb: IntArray = IntArray(frame.width)
    val depths: IntArray = IntArray(frame.width)
    val indices: IntArray = IntArray(frame.width)

    val bytes: Long get() = 12L * frame.width + 8L * keys.size

    fun choose(y: Int) {
        cell.isShown = false
        for (i in 0 until frame.width) {
            argb[i] = backgroundColor
            depths[i] = frame.raster.backgroundDepth
            indices[i] = DepthTest.BACKGROUND
            cell.x = frame.region.columnStart + i
            cell.y = y
            keys = band.gather(cell.x, y, keys)
            size = band.size
            if (size == 0) continue
            sort()
            if (mistake == Mistake.LIST_BACKGROUND_LATE && keys[0] > backgroundKey) continue
            counters.depthPasses++
            if (mistake != Mistake.LIST_SHOWN_KEPT) cell.isShown = false
            decide()
            if (!cell.isShown) continue
            argb[i] = cell.color
            depths[i] = test.depthOf(cell.shown)
            indices[i] = test.indexOf(cell.shown)
        }
    }

    private fun sort() {
        if (mistake != Mistake.LIST_TIES_AS_DRAWN) {
            keys.sort(0, size)
            return
        }
        for (i in 1 until size) {
            val key = keys[i]
            var at = i
            while (at > 0 && keys[at - 1] ushr 32 > key ushr 32) {
                keys[at] = keys[at - 1]
                at--
            }
            keys[at] = key
        }
    }

    private fun decide() {
        if (selector != null) {
            selector.select(cell)
        } else if (frame.hasTranslucency) {
            blend()
        } else {
            cell.show(0)
        }
    }

    private fun blend() {
        blender.clear()
        var i = 0
        var nearest = 0
        while (i < size && cell.isTranslucent(i) && blender.isOpen) {
            val veil = cell.shade(i++)
            blender.add(veil)
            val isClear = !(veil.alpha > 0f) && nearest == i - 1 && i < size
            if (mistake == Mistake.LIST_CLEAR_IS_NOTHING && isClear) nearest = i
        }
        val color = when {
            !blender.isOpen -> blender.finish()
            i < size -> blender.finish(cell.shade(i))
            else -> blender.finish(frame.raster.background)
        }
        cell.show(nearest, color)
    }

    /** What a selector sees of the current sample. */
    private inner class SampleCell : Cell {
        var isShown = false
        var shown = 0L
        var color = 0

        override var x: Int = 0
        override var y: Int = 0
        override val size: Int get() = this@ListChoice.size
        override val background: Rgba get() = frame.raster.background

        override fun depth(i: Int): Int = test.depthOf(keys[checked(i)])

        override fun primitive(i: Int): Int = test.indexOf(keys[checked(i)])

        override fun isTranslucent(i: Int): Boolean = frame.primitives[primitive(i)].isTranslucent

        override fun shade(i: Int): Fragment {
            counters.shadingCalls++
            counters.shadingStarts++
            fragment.moveTo(x, y)
            frame.primitives[primitive(i)].shade(fragment)
            return fragment
        }

        override fun show(i: Int) {
            show(i, shade(i).toArgb())
        }

        override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) {
            result.setColor(red, green, blue, if (mistake == Mistake.LIST_SHOWN_OPAQUE) 1f else alpha)
            show(checked(i), result.toArgb())
        }

        fun show(i: Int, argb: Int) {
            if (mistake == Mistake.LIST_FIRST_SHOW && isShown) return
            isShown = true
            shown = keys[i]
            color = argb
        }

        private fun checked(i: Int): Int {
            require(i in 0 until size) { "fragment must be in 0..${size - 1}: $i" }
            return i
        }
    }
}
