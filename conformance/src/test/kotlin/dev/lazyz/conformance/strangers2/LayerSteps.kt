package dev.lazyz.conformance.strangers2

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Selector

/** What [Layers] does, step by step; mistakes replace single steps. */
internal open class LayerSteps : BlendSteps() {
    /** The selector to ask, or null to blend. */
    open fun selector(frame: Frame, options: RenderOptions): Selector? =
        options.selector ?: if (frame.hasTranslucency) null else Selector.nearest()

    open fun passes(pass: LayerPass, key: Long): Boolean = key < pass.backgroundKey

    open fun keep(pass: LayerPass, column: Column, key: Long) = column.add(key)

    open fun sort(pass: LayerPass, column: Column) = column.keys.sort(0, column.size)

    open fun mayShow(cell: LayerCell): Boolean = true

    open fun shownInColor(i: Int): Int = i

    open fun shownDepth(i: Int): Int = i

    /** Called when the selector has spoken. */
    open fun choose(cell: LayerCell) = Unit
}

/** Rule 5.5, step by step. */
internal open class BlendSteps {
    open fun blend(cell: LayerCell) {
        if (!cell.isTranslucent(0)) {
            cell.show(0)
            return
        }
        val sums = Sums()
        var i = 0
        while (i < cell.size && letsThrough(cell, i) && isOpen(sums)) add(sums, cell, i++)
        val isOpen = isOpen(sums)
        if (isOpen && i < cell.size) {
            val last = cell.shade(i)
            end(sums, last.red, last.green, last.blue, backdropAlpha(last.alpha))
        } else {
            val last = cell.background
            if (isOpen) end(sums, last.red, last.green, last.blue, last.alpha)
        }
        finish(sums)
        cell.show(front(sums), sums.red, sums.green, sums.blue, sums.alpha)
    }

    open fun letsThrough(cell: LayerCell, i: Int): Boolean = cell.isTranslucent(i)

    open fun isOpen(sums: Sums): Boolean = sums.transmittance > 0f

    open fun backdropAlpha(alpha: Float): Float = alpha

    open fun front(sums: Sums): Int = 0

    open fun add(sums: Sums, cell: LayerCell, i: Int) {
        val fragment: Fragment = cell.shade(i)
        val alpha = clamp(fragment.alpha)
        if (isSeen(alpha)) sums.add(fragment.red, fragment.green, fragment.blue, alpha)
        sums.note(i, alpha)
    }

    open fun isSeen(alpha: Float): Boolean = alpha > 0f

    open fun clamp(alpha: Float): Float = if (!(alpha > 0f)) 0f else minOf(alpha, 1f)

    open fun end(sums: Sums, red: Float, green: Float, blue: Float, alpha: Float) {
        if (sums.weight == 0f) {
            sums.red = red
            sums.green = green
            sums.blue = blue
            sums.alpha = alpha
            sums.isDone = true
            return
        }
        val opacity = clamp(alpha)
        if (opacity > 0f) sums.add(red, green, blue, opacity)
    }

    open fun finish(sums: Sums) {
        if (sums.isDone) return
        sums.red /= sums.weight
        sums.green /= sums.weight
        sums.blue /= sums.weight
        sums.alpha = sums.weight
    }

    /** The sums of one sample. */
    class Sums {
        var transmittance = 1f
        var weight = 0f
        var red = 0f
        var green = 0f
        var blue = 0f
        var alpha = 0f
        var isDone = false

        /** The first fragment that is seen at all, or -1. */
        var firstSeen = -1

        fun add(red: Float, green: Float, blue: Float, alpha: Float) {
            val share = transmittance * alpha
            this.red += share * red
            this.green += share * green
            this.blue += share * blue
            weight += share
            transmittance *= 1f - alpha
        }

        fun note(i: Int, alpha: Float) {
            if (firstSeen < 0 && alpha > 0f) firstSeen = i
        }
    }
}
