package dev.lazyz.conformance.strangers4

import dev.lazyz.Renderer
import dev.lazyz.conformance.strangers.Stranger

/** Renderers that were written from the contract alone, and copies of them with one mistake each. */
internal object FourthGallery {
    /** Makers of the correct renderers. */
    val correct: List<() -> Renderer> =
        listOf({ TileStranger() }, { SweepStranger() }, { ListStranger() }, { PyramidStranger() })

    /** All that are wrong. */
    val all: List<Stranger> = Mistake.entries.map { Stranger(it.id, it.where, it.rules.toSet()) { make(it) } }

    /** Returns the renderer that makes [mistake], or, if [isRight], the same one without it. */
    fun make(mistake: Mistake, isRight: Boolean = false): Renderer {
        val made = if (isRight) null else mistake
        return when (mistake.name.substringBefore('_')) {
            "TILE" -> TileStranger(made)
            "SWEEP" -> SweepStranger(made)
            "LIST" -> ListStranger(made)
            else -> PyramidStranger(made)
        }
    }
}
