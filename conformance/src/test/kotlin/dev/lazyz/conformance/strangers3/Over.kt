package dev.lazyz.conformance.strangers3

import dev.lazyz.Fragment
import dev.lazyz.Rgba

/** The colour of a sample out of its fragments, nearest first (rule 5.5). */
internal class Over(private val mistake: Mistake?) {
    private var through = 1f
    private var weights = 0f
    private var red = 0f
    private var green = 0f
    private var blue = 0f

    /** The finished colour. */
    var color = Rgba(0f, 0f, 0f, 0f)
        private set

    /** Whether something behind may still be seen. */
    val isOpen: Boolean
        get() = when (mistake) {
            Mistake.TILES_BLENDS_ON -> true
            Mistake.TILES_BLEND_EPSILON -> through > 1f / 256
            else -> through > 0f
        }

    fun begin() {
        through = 1f
        weights = 0f
        red = 0f
        green = 0f
        blue = 0f
    }

    fun add(fragment: Fragment) = add(fragment.red, fragment.green, fragment.blue, clamped(fragment.alpha))

    fun end(fragment: Fragment) = end(fragment.red, fragment.green, fragment.blue, fragment.alpha)

    fun end(paper: Rgba) = end(paper.red, paper.green, paper.blue, paper.alpha)

    private fun add(r: Float, g: Float, b: Float, alpha: Float) {
        if (alpha == 0f) return
        val weight = through * alpha
        red += weight * light(r)
        green += weight * light(g)
        blue += weight * light(b)
        weights += weight
        through *= 1f - alpha
    }

    private fun light(value: Float): Float =
        if (mistake == Mistake.TILES_BLEND_CLAMPS) value.coerceIn(0f, 1f) else value

    private fun end(r: Float, g: Float, b: Float, alpha: Float) {
        if (weights == 0f && mistake != Mistake.TILES_CLEAR_FRONT) {
            color = Rgba(r, g, b, alpha)
            return
        }
        if (isOpen) add(r, g, b, if (mistake == Mistake.TILES_SOLID_BACKDROP) 1f else clamped(alpha))
        color = Rgba(red / weights, green / weights, blue / weights, weights)
    }

    private fun clamped(alpha: Float): Float = when {
        mistake == Mistake.TILES_NAN_OPAQUE && alpha.isNaN() -> 1f
        mistake == Mistake.EVENTS_ALPHA_ABOVE_ONE -> if (alpha > 0f) alpha else 0f
        alpha > 0f -> minOf(alpha, 1f)
        else -> 0f
    }
}
