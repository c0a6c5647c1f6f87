package dev.lazyz.conformance.strangers4

import dev.lazyz.Fragment
import dev.lazyz.Rgba

/**
 * Blends the fragments of a sample from the nearest on (rule 5.5). Shared by the two renderers that blend. Belongs to
 * one thread.
 */
internal class Blender(private val mistake: Mistake?) {
    private var light = 1f
    private var weights = 0f
    private var red = 0f
    private var green = 0f
    private var blue = 0f
    private val result = Fragment()

    /** Whether what lies behind can still be seen. */
    val isOpen: Boolean
        get() = if (mistake == Mistake.LIST_EARLY_OUT) light > 1f / 256f else light > 0f

    fun clear() {
        light = 1f
        weights = 0f
        red = 0f
        green = 0f
        blue = 0f
    }

    fun add(fragment: Fragment) {
        add(fragment.red, fragment.green, fragment.blue, fragment.alpha)
    }

    /** Puts an opaque fragment behind all. */
    fun finish(backdrop: Fragment): Int {
        val alpha = if (mistake == Mistake.LIST_BACKDROP_OPAQUE && weights > 0f) 1f else backdrop.alpha
        return finish(backdrop.red, backdrop.green, backdrop.blue, alpha)
    }

    /** Puts the background behind all. */
    fun finish(background: Rgba): Int {
        val alpha = if (mistake == Mistake.TILE_BACKGROUND_OPAQUE && weights > 0f) 1f else background.alpha
        return finish(background.red, background.green, background.blue, alpha)
    }

    /** Returns the colour when nothing of the backdrop can be seen. */
    fun finish(): Int = divided()

    private fun finish(red: Float, green: Float, blue: Float, alpha: Float): Int {
        if (weights == 0f) {
            result.setColor(red, green, blue, alpha)
            return result.toArgb()
        }
        add(red, green, blue, alpha)
        return divided()
    }

    private fun add(red: Float, green: Float, blue: Float, alpha: Float) {
        val opacity = clamped(alpha)
        if (opacity == 0f) return
        val weight = light * opacity
        this.red += weight * red
        this.green += weight * green
        this.blue += weight * blue
        weights += weight
        light *= 1f - opacity
    }

    private fun divided(): Int {
        if (mistake == Mistake.LIST_PREMULTIPLIED) {
            result.setColor(red, green, blue, weights)
        } else {
            result.setColor(red / weights, green / weights, blue / weights, weights)
        }
        return result.toArgb()
    }

    private fun clamped(alpha: Float): Float = when {
        mistake == Mistake.TILE_ALPHA_NAN -> alpha.coerceIn(0f, 1f)
        !(alpha > 0f) -> 0f
        alpha > 1f -> 1f
        else -> alpha
    }
}
