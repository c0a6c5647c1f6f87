package dev.lazyz.conformance.strangers5

import dev.lazyz.Renderer
import dev.lazyz.conformance.strangers.Stranger

/** Renderers that were written from the contract alone, and copies of them with one mistake each. */
internal object FifthGallery {
    /** Those that are right. */
    val correct: List<() -> Renderer> = listOf(::rightCaster, ::rightDeferred, ::rightPeeler, ::rightSpanBuffer)

    /** All that are wrong. */
    val all: List<Stranger> = Mistake.entries.map { Stranger(it.id, it.where, it.rules.toSet()) { make(it) } }

    /** Returns the renderer with a [mistake], or, if it [isRight], the one of the same architecture without. */
    fun make(mistake: Mistake, isRight: Boolean = false): Renderer {
        val made = mistake.takeUnless { isRight }
        return when (mistake.name.substringBefore('_')) {
            "CASTER" -> Caster(mistake = made)
            "DEFERRED" -> Deferred(mistake = made)
            "PEELER" -> Peeler(mistake = made)
            else -> SpanBuffer(made)
        }
    }

    private fun rightCaster(): Renderer = Caster()

    private fun rightDeferred(): Renderer = Deferred()

    private fun rightPeeler(): Renderer = Peeler()

    private fun rightSpanBuffer(): Renderer = SpanBuffer()
}
