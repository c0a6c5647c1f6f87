package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Renderer
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Nearest
import dev.lazyz.strategies.Renderers

/** Renderers by the name that a user types, and by what they are capable of. */
internal object Strategies {
    /** All renderers; a class path with two of one id is the user's to mend. */
    fun all(): List<Renderer> = try {
        Renderers.all()
    } catch (clash: IllegalStateException) {
        throw Mistake(clash.message.orEmpty())
    } catch (broken: LinkageError) {
        throw Mistake("a renderer on the class path cannot be loaded: $broken\nIs a jar that it needs missing?")
    }

    fun find(id: String): Renderer {
        val all = all()
        return all.firstOrNull { it.id == id } ?: throw Mistake(
            "no strategy '$id'${Nearest.hint(id, all.map { it.id })}\nSee 'zcli strategies'.",
        )
    }

    /** Whether the strategy called [id] is ours. */
    fun isBuiltIn(id: String): Boolean = Renderers.builtIn.any { it.id == id }

    /** Returns who is capable of [capability], for people: `hybrid does`, `lazy, flow do`, `no strategy does`. */
    fun whoDoes(capability: Capability): String {
        val ids = all().filter { capability in it.capabilities }.map { it.id }
        return if (ids.size > 1) ids.joinToString() + " do" else (ids.singleOrNull() ?: "no strategy") + " does"
    }

    /** Returns those of [needs] that are not among [capabilities], each with who is capable of it; or null. */
    fun missing(needs: Map<String, Capability>, capabilities: Set<Capability>): String? =
        needs.filterValues { it !in capabilities }.ifEmpty { null }?.let { withWhoDoes(it) }

    /** Returns the flags of [needs], each with who heeds it: `--select (lists does), --threads (no strategy does)`. */
    fun withWhoDoes(needs: Map<String, Capability>): String =
        needs.entries.joinToString { (flag, capability) -> "$flag (${whoDoes(capability)})" }
}
