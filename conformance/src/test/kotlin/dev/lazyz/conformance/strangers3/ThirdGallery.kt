package dev.lazyz.conformance.strangers3

import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.strangers.Stranger

/** The third set of strangers: five renderers that are right, and one for each [Mistake]. */
internal object ThirdGallery {
    /** Each gives a renderer of its own. */
    val correct: List<() -> Renderer> =
        listOf({ SpanMerge() }, { ColumnSplit() }, { StealingTiles() }, { EventSweep() }, { QueueBuffer() })

    /** All that are wrong. */
    val all: List<Stranger> = Mistake.entries.map { Stranger(it.id, it.where, it.rules.toSet()) { make(it) } }

    /** Returns the renderer that makes [mistake], or the right one that it is made of. */
    fun make(mistake: Mistake, isRight: Boolean = false): Renderer {
        val options = RenderOptions()
        val made = if (isRight) null else mistake
        return when (mistake.name.substringBefore('_')) {
            "SPANS" -> SpanMerge(options, made)
            "COLUMNS" -> ColumnSplit(options, made)
            "TILES" -> StealingTiles(options, made)
            "EVENTS" -> EventSweep(options, made)
            else -> QueueBuffer(options, made)
        }
    }
}
