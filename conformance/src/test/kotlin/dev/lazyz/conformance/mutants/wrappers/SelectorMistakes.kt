package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.Selector.Cell
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.spi.Fragment
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that ignore the caller's selector, or give it wrong cells. */
internal object SelectorMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::ignoresTheSelector, "promises selection, but shows the nearest fragment"),
        Mistake(::cellsFromTheBack, "the selector gets the fragments from back to front"),
        Mistake(::wrapsAlpha, "an alpha just above 1 that a selector shows is nearly transparent"),
        Mistake(::shadesAFewHundred, "the selector gets the colours of 256 fragments"),
        Mistake(::cutsColumns, "the selector gets columns of 16 bits"),
        Mistake(::selectsTwice, "the selector is called twice for each sample"),
        Mistake(::skipsSingleFragments, "the selector is not called where there is one fragment"),
    )

    fun ignoresTheSelector() = selecting("ignores-the-selector") { Selector.nearest() }

    fun cellsFromTheBack() = selecting("cells-from-the-back") { selector -> Selector { selector.select(Reversed(it)) } }

    private class Reversed(private val cell: Cell) : Cell by cell {
        private fun at(i: Int) = cell.size - 1 - i

        override fun depth(i: Int) = cell.depth(at(i))

        override fun primitive(i: Int) = cell.primitive(at(i))

        override fun shade(i: Int) = cell.shade(at(i))

        override fun show(i: Int) = cell.show(at(i))
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

    fun selectsTwice() = selecting("selects-twice") { selector ->
        Selector { cell ->
            selector.select(cell)
            selector.select(cell)
        }
    }

    fun skipsSingleFragments() = selecting("selects-among-several-only") { selector ->
        Selector { cell -> if (cell.size == 1) cell.show(0) else selector.select(cell) }
    }

    private fun selecting(id: String, change: (Selector) -> Selector) = BrokenRenderer(
        id,
        setOf(Capability.SELECTION),
        { options -> ListsRenderer(RenderOptions(selector = options.selector?.let(change))) },
    ) { frame, sink -> ZBufferRenderer().render(frame, sink) }
}
