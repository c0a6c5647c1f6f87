package dev.lazyz.cli

import dev.lazyz.Renderer
import dev.lazyz.Renderers

/** Renderers by the name that a user types. */
internal object Strategies {
    /** All renderers; a class path with two of one id is the user's to mend. */
    fun all(): List<Renderer> = try {
        Renderers.all()
    } catch (clash: IllegalStateException) {
        throw Mistake(clash.message.orEmpty())
    }

    fun find(id: String): Renderer {
        val all = all()
        return all.firstOrNull { it.id == id } ?: throw Mistake(
            "no strategy '$id'${Nearest.hint(id, all.map { it.id })}\nSee 'zcli strategies'.",
        )
    }
}
