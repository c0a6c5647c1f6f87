package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.Selector

/**
 * The [RenderOptions] that the user chose; null if the user did not give the option.
 *
 * @param share the number of threads for a picture that is rendered next to others; then --threads is for all of them,
 *   and no strategy needs to support it
 * @param isTranslucent whether these are for a frame with translucent surfaces
 */
internal class Choices(
    private val memoryBudget: Long?,
    private val coherence: Coherence?,
    private val threads: Int?,
    private val tileSize: Int?,
    private val selector: Selector? = null,
    private val share: Int? = null,
    private val isTranslucent: Boolean = false,
) {
    /** The selector of the options, or null: each strategy shows the nearest of opaque surfaces. */
    private val neededSelector = selector.takeIf { isTranslucent || it != Selector.nearest() }

    /** The options that the user gave, each with the capability that a strategy must have to support it. */
    val needs: Map<String, Capability> = listOfNotNull(
        memoryBudget?.let { "--memory-budget" to Capability.MEMORY_BUDGET },
        coherence?.let { "--coherence" to Capability.COHERENCE },
        threads?.takeIf { share == null }?.let { "--threads" to Capability.PARALLEL },
        tileSize?.let { "--tile-size" to Capability.PARALLEL },
        neededSelector?.let { "--select" to Capability.SELECTION },
    ).toMap()

    /** Returns [renderer] with those of these choices that it supports, or unchanged if there are none. */
    fun applyTo(renderer: Renderer): Renderer =
        if (needs.isEmpty() && share == null) renderer else renderer.configured(options().supportedBy(renderer))

    /** Returns these choices for a picture that is rendered by [share] threads, next to others. */
    fun sharing(share: Int) = Choices(memoryBudget, coherence, threads, tileSize, selector, share, isTranslucent)

    /** Returns these choices for [frame]. */
    fun forFrame(frame: Frame) =
        Choices(memoryBudget, coherence, threads, tileSize, selector, share, frame.hasTranslucency)

    /** Returns these choices as options, with the defaults where the user chose nothing. */
    fun options(): RenderOptions {
        val usual = RenderOptions()
        return RenderOptions(
            coherence ?: usual.coherence,
            memoryBudget,
            share ?: threads ?: usual.threads,
            tileSize ?: usual.tileSize,
            neededSelector,
        )
    }
}
