package dev.lazyz.lighting

import dev.lazyz.Fragment
import dev.lazyz.Rgba
import dev.lazyz.Shader

/** The colour of ground with the shadows of [grid], each multiplied by [strength], in front of [background]. */
internal class GroundShader(private val grid: ShadowGrid, private val strength: Float, private val background: Rgba,) :
    Shader {
    override fun shade(fragment: Fragment) {
        val shadow = strength * grid.at(fragment.worldX, fragment.worldZ)

        // Black with the alpha of the shadow, over the background
        val seen = background.alpha * (1f - shadow)
        val alpha = shadow + seen
        val part = if (alpha > 0f) seen / alpha else 0f
        fragment.setColor(background.red * part, background.green * part, background.blue * part, alpha)
    }
}
