package dev.lazyz.conformance.strangers2

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Rgba
import dev.lazyz.conformance.strangers.Stranger

/** Mistakes of shading in a renderer that goes row by row. */
internal fun rowColorMistakes(): List<Stranger> = listOf(
    wrongRows("keeps-the-hue", "a colour with a component above 1 is scaled until none is", "6.4") {
        object : RowSteps() {
            override fun pack(fragment: Fragment): Int {
                val most = maxOf(fragment.red, fragment.green, fragment.blue)
                if (!(most > 1f) || most.isInfinite()) return fragment.toArgb()
                return Rgba(fragment.red / most, fragment.green / most, fragment.blue / most, fragment.alpha).toArgb()
            }
        }
    },
    wrongRows("chain-outlives-row", "under adaptive coherence chains of the row above go on", "7.5", "6.1") {
        object : RowSteps() {
            override fun beginColors(chains: HashMap<Int, RowColors.Chain>, coherence: Coherence) {
                if (coherence != Coherence.ADAPTIVE) chains.clear()
            }
        }
    },
    wrongRows("whole-chain", "the longest chain is taken from the chain's first column, not from its last use", "8.1") {
        object : RowSteps() {
            override fun count(counters: Counters.Builder, gap: Int, chain: RowColors.Chain) {
                super.count(counters, gap, chain)
                counters.longestChain = maxOf(counters.longestChain, chain.length.toLong())
            }
        }
    },
    wrongRows("fragment-stays", "while a chain is stepped the fragment stays where it was", "6.2", "7.5") {
        object : RowSteps() {
            override fun moveTo(fragment: Fragment, x: Int, y: Int, chain: RowColors.Chain?) {
                if (chain == null || !chain.isUsed) super.moveTo(fragment, x, y, chain)
            }
        }
    },
    wrongRows("no-cursor-no-change", "what has no shading cursor is taken for one colour a run", "6.1", "8.2") {
        object : RowSteps() {
            override fun color(pass: RowPass, colors: RowColors, i: Int, y: Int): Int {
                val index = pass.indices[i]
                val mayCopy = pass.options.coherence == Coherence.INCREMENTAL && i > 0 &&
                    index != DepthTest.BACKGROUND && index == pass.indices[i - 1]
                val hasCursor = !mayCopy ||
                    pass.frame.primitives[index].shadingCursor(pass.region.columnStart + i, y) != null
                return if (hasCursor) super.color(pass, colors, i, y) else pass.argb[i - 1]
            }
        }
    },
)
