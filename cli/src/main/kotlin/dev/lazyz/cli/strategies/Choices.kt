package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Selector

/** What the user chose of [RenderOptions]; null means: not said. */
internal class Choices(
    private val memoryBudget: Long?,
    private val coherence: Coherence?,
    private val threads: Int?,
    private val tileSize: Int?,
    private val selector: Selector? = null,
) {
    /** The flags that were said, each with what a strategy must be capable of to heed it. */
    val needs: Map<String, Capability> = listOfNotNull(
        memoryBudget?.let { "--memory-budget" to Capability.MEMORY_BUDGET },
        coherence?.let { "--coherence" to Capability.COHERENCE },
        threads?.let { "--threads" to Capability.PARALLEL },
        tileSize?.let { "--tile-size" to Capability.PARALLEL },
        selector?.let { "--select" to Capability.SELECTION },
    ).toMap()

    /** Returns [renderer] with these choices, or as it is if there are none. */
    fun applyTo(renderer: Renderer): Renderer = if (needs.isEmpty()) renderer else renderer.configured(options())

    /** Returns the options that these choices are, the usual where nothing was said. */
    fun options(): RenderOptions {
        val usual = RenderOptions()
        return RenderOptions(
            coherence ?: usual.coherence,
            memoryBudget,
            threads ?: usual.threads,
            tileSize ?: usual.tileSize,
            selector,
        )
    }
}
