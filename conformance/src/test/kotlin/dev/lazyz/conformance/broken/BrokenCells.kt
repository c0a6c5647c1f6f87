package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Cell
import dev.lazyz.Fragment
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.zbuffer.ZBuffer

/** Renderers that ignore the caller's selector, or give it wrong cells. */
internal object BrokenCells {
    fun keepsItsSelector(): BrokenRenderer = keepsItsSelector(RenderOptions())

    private fun keepsItsSelector(last: RenderOptions): BrokenRenderer = BrokenRenderer(
        "keeps-its-selector",
        setOf(Capability.SELECTION),
        options = { keepsItsSelector(if (it.selector == null) last else it) },
    ) { frame, sink -> Lists(last).render(frame, sink) }

    fun ignoresTheSelector() = selecting("ignores-the-selector") { Selector.nearest() }

    fun selectsWithoutTheNearest() = selecting("selects-without-the-nearest") { selector ->
        Selector { cell -> selector.select(if (cell.size == 1) cell else Behind(cell)) }
    }

    fun cellsFromTheBack() = selecting("cells-from-the-back") { selector -> Selector { selector.select(Reversed(it)) } }

    fun firstShowDecides() = selecting("first-show-decides") { selector ->
        Selector { cell -> selector.select(ShownOnce(cell)) }
    }

    private class ShownOnce(private val cell: Cell) : Cell by cell {
        private var isShown = false

        override fun show(i: Int) {
            if (!isShown) cell.show(i)
            isShown = true
        }

        override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) {
            if (!isShown) cell.show(i, red, green, blue, alpha)
            isShown = true
        }
    }

    private class Behind(private val cell: Cell) : Cell by cell {
        override val size: Int get() = cell.size - 1

        override fun depth(i: Int) = cell.depth(i + 1)

        override fun primitive(i: Int) = cell.primitive(i + 1)

        override fun shade(i: Int) = cell.shade(i + 1)

        override fun show(i: Int) = cell.show(i + 1)
    }

    private class Reversed(private val cell: Cell) : Cell by cell {
        private fun at(i: Int) = cell.size - 1 - i

        override fun depth(i: Int) = cell.depth(at(i))

        override fun primitive(i: Int) = cell.primitive(at(i))

        override fun shade(i: Int) = cell.shade(at(i))

        override fun show(i: Int) = cell.show(at(i))
    }

    fun coarseBackground() = selecting("selectors-see-a-coarse-background") { selector ->
        Selector { cell -> selector.select(Coarse(cell)) }
    }

    private class Coarse(private val cell: Cell) : Cell by cell {
        override val background: Rgba
            get() = with(cell.background) { Rgba(coarse(red), coarse(green), coarse(blue), alpha) }

        private fun coarse(value: Float): Float = Math.round(value * 255f) / 255f
    }

    fun wrapsAlpha() = selecting("selected-alpha-wraps") { selector -> Selector { selector.select(Wrapping(it)) } }

    private class Wrapping(private val cell: Cell) : Cell by cell {
        override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) =
            cell.show(i, red, green, blue, if (alpha > 1f && alpha < 1.01f) alpha - 1f else alpha)
    }

    fun shadesAFewHundred() = selecting("selectors-shade-a-few-hundred") { selector ->
        Selector { cell -> selector.select(Shallow(cell)) }
    }

    private class Shallow(private val cell: Cell) : Cell by cell {
        override fun shade(i: Int): Fragment = cell.shade(minOf(i, 255))
    }

    fun cutsColumns() = selecting("selectors-see-16-bit-columns") { selector -> Selector { selector.select(Near(it)) } }

    private class Near(private val cell: Cell) : Cell by cell {
        override val x: Int get() = cell.x and 0xFFFF
    }

    /** Cells of one renderer share a field. */
    fun oneCell(): BrokenRenderer {
        var current: Cell? = null
        return selecting("one-cell-for-all") { selector ->
            Selector { cell ->
                current = cell
                selector.select(Current { checkNotNull(current) })
            }
        }
    }

    private class Current(private val cell: () -> Cell) : Cell {
        override val x: Int get() = cell().x
        override val y: Int get() = cell().y
        override val size: Int get() = cell().size
        override val background: Rgba get() = cell().background

        override fun depth(i: Int): Int = cell().depth(i)

        override fun primitive(i: Int): Int = cell().primitive(i)

        override fun isTranslucent(i: Int): Boolean = cell().isTranslucent(i)

        override fun shade(i: Int): Fragment = cell().shade(i)

        override fun show(i: Int) = cell().show(i)

        override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) =
            cell().show(i, red, green, blue, alpha)
    }

    fun selectsTwice() = selecting("selects-twice") { selector ->
        Selector { cell ->
            selector.select(cell)
            selector.select(cell)
        }
    }

    fun skipsSingleFragments() = selecting("selects-among-several-only") { selector ->
        Selector { cell -> if (cell.size == 1) cell.show(0) else selector.select(cell) }
    }

    fun losesInterrupts() = selecting("loses-interrupts-of-selectors") { selector ->
        val caller = Thread.currentThread()
        Selector { cell ->
            val was = caller.isInterrupted
            selector.select(cell)
            if (!was && Thread.currentThread() === caller) Thread.interrupted()
        }
    }

    private fun selecting(id: String, change: (Selector) -> Selector) = BrokenRenderer(
        id,
        setOf(Capability.SELECTION),
        { options -> Lists(RenderOptions(selector = options.selector?.let(change))) },
    ) { frame, sink -> ZBuffer().render(frame, sink) }
}
