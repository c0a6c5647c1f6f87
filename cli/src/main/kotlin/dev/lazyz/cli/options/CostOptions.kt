package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Selector
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.scenes.pictures.NamedValues

/** Options that change time and memory of the rendering. */
internal class CostOptions : OptionGroup("Cost (the picture stays the same; see 'zcli strategies --long')") {
    private val memoryBudget by option(
        "--memory-budget",
        help = "Maximum working memory of a strategy that can limit it, without the picture and the scene: bytes, or " +
            "with k, m, g (64k, 16MiB); default: no limit. --memory, in contrast, is for the whole program",
    ).bytes()

    private val coherence by option(
        "--coherence",
        help = "How late shading proceeds from pixel to pixel: direct (each separately), incremental (by steps) or " +
            "adaptive (the cheaper one); default: direct",
    ).oneOf("MODE", NamedValues.words(Coherence.entries))

    private val threads by option("--threads", help = "Number of threads, 1 or more; default: one per processor")
        .count { RenderOptions(threads = it) }

    private val tileSize by option(
        "--tile-size",
        help = "Width and height of tiles, a power of two in 8..512; default: ${RenderOptions().tileSize}",
    ).count { RenderOptions(tileSize = it) }

    fun choices(selector: Selector? = null) = Choices(memoryBudget, coherence, threads, tileSize, selector)
}
