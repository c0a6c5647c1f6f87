package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Renderer
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Nearest
import dev.lazyz.strategies.Renderers

/** Finds renderers by id and by capability. */
internal object Strategies {
    /**
     * Returns all renderers.
     *
     * @throws Mistake if two have the same id, or one cannot be loaded
     */
    fun all(): List<Renderer> = try {
        Renderers.all()
    } catch (clash: IllegalStateException) {
        throw Mistake(clash.message.orEmpty())
    } catch (broken: LinkageError) {
        throw Mistake("a renderer on the class path cannot be loaded: $broken\nIs a jar that it needs missing?")
    }

    /** Returns the ids of all renderers. */
    fun ids(): List<String> = all().map { it.id }

    fun find(id: String): Renderer {
        val all = all()
        return all.firstOrNull { it.id == id } ?: throw Mistake(
            "no strategy '$id'${Nearest.hint(id, ids())}\nSee 'zcli strategies'.",
        )
    }

    /** Returns whether the strategy [id] is built in. */
    fun isBuiltIn(id: String): Boolean = Renderers.builtIn.any { it.id == id }

    /** Returns text about the strategies with [capability]: `hybrid does`, `lazy, flow do`, `no strategy does`. */
    fun supporters(capability: Capability): String {
        val ids = all().filter { capability in it.capabilities }.map { it.id }
        return if (ids.size > 1) ids.joinToString() + " do" else (ids.singleOrNull() ?: "no strategy") + " does"
    }

    /** Returns those of [needs] that are not in [capabilities], each with the strategies that support it; or null. */
    fun missing(needs: Map<String, Capability>, capabilities: Set<Capability>): String? =
        needs.filterValues { it !in capabilities }.ifEmpty { null }?.let { withSupporters(it) }

    /**
     * Returns the options of [needs], each with the strategies that support it: `--select (lists does), --threads (no
     * strategy does)`.
     */
    fun withSupporters(needs: Map<String, Capability>): String =
        needs.entries.joinToString { (option, capability) -> "$option (${supporters(capability)})" }
}
