package dev.lazyz.cli

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Renderer

/**
 * The strategy of a rendering: the one that the user named, or the first that is capable of what the flags and the
 * frame need. Throws [Mistake] if there is none, for the flags' sake at once.
 *
 * @param id what the user named, or null
 */
internal class StrategyChoice(id: String?, private val choices: Choices) {
    private val named: Renderer? = id?.let { Strategies.find(it) }

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
        val configured = candidates.asSequence().map { choices.applyTo(it) }
        if (!frame.hasTranslucency) return configured.first()
        return configured.firstOrNull { Capability.TRANSPARENCY in it.capabilities } ?: throw Mistake(cannotBlend())
    }

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

    private companion object {
        const val SEE = "\nSee 'zcli strategies --long'."
    }
}
