package dev.lazyz.conformance.strangers2

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor

/** The colours of a row, once it is known what is visible. */
internal class RowColors(private val pass: RowPass) {
    private val steps = pass.steps
    private val coherence = pass.options.coherence
    private val counters = pass.counters
    val fragment = Fragment()
    val chains = HashMap<Int, Chain>()

    fun row(y: Int) {
        steps.beginColors(chains, coherence)
        for (i in 0 until pass.width) pass.argb[i] = steps.color(pass, this, i, y)
        pass.extraBytes = maxOf(pass.extraBytes, 120L * chains.size)
    }

    fun shade(x: Int, y: Int, index: Int): Int {
        val primitive = pass.frame.primitives[index]
        counters.shadingCalls++
        val chain = if (steps.maySteps(coherence, primitive)) chainAt(x, y, index, primitive) else null
        steps.moveTo(fragment, x, y, chain)
        if (chain != null) {
            chain.cursor.shade(fragment)
            chain.isUsed = true
        } else {
            counters.shadingStarts++
            primitive.shade(fragment)
        }
        return steps.pack(fragment)
    }

    private fun chainAt(x: Int, y: Int, index: Int, primitive: Primitive): Chain? {
        val chain = chains[index]
        if (chain != null && steps.isWorth(coherence, x - chain.x, primitive)) {
            val gap = x - chain.x
            for (step in 0 until gap) chain.cursor.step()
            chain.x = x
            chain.length += gap
            steps.count(counters, gap, chain)
            return chain
        }
        val cursor = primitive.shadingCursor(x, y) ?: return null
        counters.shadingStarts++
        return Chain(cursor, x).also { chains[index] = it }
    }

    /** Shading that steps along the row. */
    class Chain(val cursor: ShadingCursor, var x: Int) {
        var length = 0
        var isUsed = false
    }
}

/** What [RowColors] does, step by step. */
internal open class ColorSteps {
    open fun beginColors(chains: HashMap<Int, RowColors.Chain>, coherence: Coherence) = chains.clear()

    open fun color(pass: RowPass, colors: RowColors, i: Int, y: Int): Int {
        val index = pass.indices[i]
        if (index == DepthTest.BACKGROUND) return background(pass)
        return colors.shade(pass.region.columnStart + i, y, index)
    }

    open fun background(pass: RowPass): Int = pass.background

    open fun maySteps(coherence: Coherence, primitive: Primitive): Boolean = when (coherence) {
        Coherence.DIRECT -> false
        Coherence.INCREMENTAL -> true
        Coherence.ADAPTIVE -> primitive.shadingStartCost > 0
    }

    open fun isWorth(coherence: Coherence, gap: Int, primitive: Primitive): Boolean =
        coherence == Coherence.INCREMENTAL || gap <= primitive.shadingStartCost

    open fun count(counters: Counters.Builder, gap: Int, chain: RowColors.Chain) {
        counters.shadingSteps += gap
        counters.longestChain = maxOf(counters.longestChain, gap.toLong())
    }

    open fun moveTo(fragment: Fragment, x: Int, y: Int, chain: RowColors.Chain?) = fragment.moveTo(x, y)

    open fun pack(fragment: Fragment): Int = fragment.toArgb()
}
