package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.Selector
import dev.lazyz.StreamingRenderer
import dev.lazyz.cli.output.Mistake
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.Renderers.StrategyEstimates

/**
 * Chooses the strategy of a rendering: the one that the user named, or the first that supports what the options and the
 * frame need, or, with [AUTO], another one of these if it is expected to be much faster. Throws [Mistake] if there is
 * none; the constructor already throws if no strategy supports the options.
 *
 * @param id the id that the user named, [AUTO], or null
 */
internal class StrategyChoice(private val id: String?, private val choices: Choices) {
    private val isAutomatic = id == AUTO
    private val named: Renderer? = id?.takeIf { it != AUTO }?.let { Strategies.find(it) }

    /** The strategies that support all options, in the order of the list. */
    private val candidates: List<Renderer> = if (named != null) listOf(named) else capable(choices.needs.values)

    init {
        if (named != null) {
            val missing = Strategies.missing(choices.needs, named.capabilities)
            if (missing != null) throw Mistake("strategy '${named.id}' does not support $missing$SEE")
        }
        if (candidates.isEmpty()) throw Mistake(unsupported() + SEE)
    }

    /** Whether a strategy that supports all options renders models that are read part by part. */
    val canStream: Boolean get() = candidates.any { it is StreamingRenderer }

    /** The strategy for most frames: the first that supports all options. */
    val usual: Renderer get() = candidates.first()

    /**
     * Returns the strategies that can be used for [frame] with [memory] bytes: first the one that [strategyFor]
     * returns, then the others in the order of the list.
     */
    fun rendererChoices(frame: Frame, memory: Long): List<Renderer> {
        val own = forFrame(frame)
        if (own !== this) return own.rendererChoices(frame, memory)
        val first = strategyFor(frame, memory)
        return listOf(first) + candidates.filter { it.id != first.id }.map { choices.applyTo(it) }
    }

    /** Returns the choice for [frame], which needs more capabilities if its translucent surfaces do. */
    private fun forFrame(frame: Frame): StrategyChoice {
        val own = choices.forFrame(frame)
        return if (own.needs == choices.needs) this else StrategyChoice(id, own)
    }

    /** Returns the strategy for [frame], configured as chosen. */
    fun strategyFor(frame: Frame, memory: Long = Runtime.getRuntime().maxMemory()): Renderer {
        val own = forFrame(frame)
        if (own !== this) return own.strategyFor(frame, memory)
        if (frame.isStreamed) return streaming(frame)
        if (isAutomatic) estimates(frame, memory).best?.let { return it.renderer }
        val configured = candidates.asSequence().map { choices.applyTo(it) }
        if (!frame.hasTranslucency) return configured.first()
        return configured.firstOrNull { Capability.TRANSPARENCY in it.capabilities } ?: throw Mistake(cannotBlend())
    }

    private fun streaming(frame: Frame): Renderer {
        val able = candidates.filter { it is StreamingRenderer }
        if (able.isEmpty()) {
            val all = Strategies.all().filter { it is StreamingRenderer }.joinToString { it.id }
            val reason =
                if (named != null) "strategy '${named.id}' needs" else "the strategies that support ${options()} need"
            throw Mistake("$reason the whole model in memory; with --stream use one of $all, or omit --stream")
        }
        if (!frame.hasTranslucency) return choices.applyTo(able.first())
        return able.firstOrNull { Capability.TRANSPARENCY in it.capabilities }?.let { choices.applyTo(it) }
            ?: throw Mistake("the scene is translucent, and with --stream only tiled blends: use it, or add --opaque")
    }

    /**
     * Returns lines that explain why [strategy] was chosen for [frame], with the expected cost of each strategy, if
     * [memory] bytes may be used.
     */
    fun explain(strategy: Renderer, frame: Frame, memory: Long): String {
        val own = forFrame(frame)
        if (own !== this) return own.explain(strategy, frame, memory)
        if (frame.isStreamed) {
            val why = if (named != null) "--strategy names it" else "it is the first that renders streamed models"
            return "${frame.primitives.size} primitives are read part by part\nchosen: ${strategy.id}, because $why\n"
        }
        val estimates = estimates(frame, memory)
        val best = estimates.best?.renderer?.id
        val reason = when {
            named != null -> "--strategy names it"
            isAutomatic && strategy.id == estimates.all.first().renderer.id -> "it is expected to be the fastest"
            isAutomatic && best != null -> "no other is expected to be ${StrategyEstimates.MARGIN} times as fast"
            isAutomatic -> "all are ruled out, and it is the first that is capable of this"
            else -> "it is the first of 'zcli strategies' that is capable of this"
        }
        val other = if (best == null || best == strategy.id) "" else "; --strategy auto would choose $best"
        return "${estimates.explain()}chosen: ${strategy.id}, because $reason$other\n"
    }

    private fun estimates(frame: Frame, memory: Long): StrategyEstimates =
        Renderers.estimates(frame, choices.options(), choices.needs.values.toSet(), memory)

    private fun unsupported(): String {
        val option = choices.needs.keys.singleOrNull() ?: return "no single strategy supports all of " + options()
        return "no strategy supports $option"
    }

    private fun options(): String = Strategies.withSupporters(choices.needs)

    private fun cannotBlend(): String {
        val reason = when {
            named != null -> "strategy '${named.id}' does not blend"
            else -> "no strategy that supports ${options()} blends"
        }
        val option = if (named != null) "--strategy" else choices.needs.keys.joinToString()
        return "the scene is translucent, and $reason (${Strategies.supporters(Capability.TRANSPARENCY)})\n" +
            "Omit $option, or render the scene as opaque with --opaque."
    }

    private fun capable(needs: Collection<Capability>): List<Renderer> =
        Strategies.all().filter { it.capabilities.containsAll(needs) }

    companion object {
        /** The value of --strategy that means: choose by [StrategyEstimates]. */
        const val AUTO = "auto"

        private const val SEE = "\nSee 'zcli strategies --long'."
    }
}

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
