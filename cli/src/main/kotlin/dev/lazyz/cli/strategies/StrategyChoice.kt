package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.cli.output.Mistake
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.StrategyEstimates
import dev.lazyz.strategies.StrategyModel

/**
 * The strategy of a rendering: the one that the user named, or the first that is capable of what the flags and the
 * frame need, or, with [AUTO], another one of those that is expected to be much faster. Throws [Mistake] if there is
 * none, for the flags' sake at once.
 *
 * @param id what the user named, or null
 */
internal class StrategyChoice(id: String?, private val choices: Choices) {
    private val isAutomatic = id == AUTO
    private val named: Renderer? = id?.takeIf { it != AUTO }?.let { Strategies.find(it) }

    /** Those that heed all flags, in the order in which they are listed. */
    private val candidates: List<Renderer> = if (named != null) listOf(named) else capable(choices.needs.values)

    init {
        if (named != null) {
            val missing = Strategies.missing(choices.needs, named.capabilities)
            if (missing != null) throw Mistake("strategy '${named.id}' does not heed $missing$SEE")
        }
        if (candidates.isEmpty()) throw Mistake(noneHeeds() + SEE)
    }

    /** Returns the strategy for [frame], configured as chosen. */
    fun strategyFor(frame: Frame): Renderer {
        if (isAutomatic) estimates(frame).best?.let { return it.renderer }
        val configured = candidates.asSequence().map { choices.applyTo(it) }
        if (!frame.hasTranslucency) return configured.first()
        return configured.firstOrNull { Capability.TRANSPARENCY in it.capabilities } ?: throw Mistake(cannotBlend())
    }

    /** Returns lines that say why [strategy] renders [frame], and what each would take. */
    fun explain(strategy: Renderer, frame: Frame): String {
        val estimates = estimates(frame)
        val best = estimates.best?.renderer?.id
        val reason = when {
            named != null -> "--strategy names it"
            isAutomatic && strategy.id == estimates.all.first().renderer.id -> "it is expected to be the fastest"
            isAutomatic && best != null -> "no other is expected to be ${StrategyModel.DOUBT} times as fast"
            isAutomatic -> "all are ruled out, and it is the first that is capable of this"
            else -> "it is the first of 'zcli strategies' that is capable of this"
        }
        val other = if (best == null || best == strategy.id) "" else "; --strategy auto would choose $best"
        return "${estimates.explain()}chosen: ${strategy.id}, because $reason$other\n"
    }

    private fun estimates(frame: Frame): StrategyEstimates =
        Renderers.estimates(frame, choices.options(), choices.needs.values.toSet())

    private fun noneHeeds(): String {
        val flag = choices.needs.keys.singleOrNull() ?: return "no one strategy heeds all of " + flags()
        return "no strategy heeds $flag"
    }

    private fun flags(): String = Strategies.withWhoDoes(choices.needs)

    private fun cannotBlend(): String {
        val who = when {
            named != null -> "strategy '${named.id}' does not blend"
            else -> "no strategy that heeds ${flags()} blends"
        }
        val flag = if (named != null) "--strategy" else choices.needs.keys.joinToString()
        return "the scene is translucent, and $who (${Strategies.whoDoes(Capability.TRANSPARENCY)})\n" +
            "Leave out $flag, or render the scene as opaque with --opaque."
    }

    private fun capable(needs: Collection<Capability>): List<Renderer> =
        Strategies.all().filter { it.capabilities.containsAll(needs) }

    companion object {
        /** In place of an id: choose by [StrategyModel]. */
        const val AUTO = "auto"

        private const val SEE = "\nSee 'zcli strategies --long'."
    }
}
