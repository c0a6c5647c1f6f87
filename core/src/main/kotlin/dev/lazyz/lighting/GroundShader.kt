package dev.lazyz.lighting

import dev.lazyz.Fragment
import dev.lazyz.Raster
import dev.lazyz.Shader

/**
 * The colour of ground with the shadows of [grid], each multiplied by [strength], in front of the background of
 * [raster]. Toward the border of the raster, the shadows fade to nothing.
 */
internal class GroundShader(private val grid: ShadowGrid, private val strength: Float, private val raster: Raster) :
    Shader {
    private val background = raster.background
    private val side = minOf(raster.width, raster.height)

    override fun shade(fragment: Fragment) {
        val shadow = strength * grid.at(fragment.worldX, fragment.worldZ) * fading(fragment.x, fragment.y)

        // Black with the alpha of the shadow, over the background
        val seen = background.alpha * (1f - shadow)
        val alpha = shadow + seen
        val part = if (alpha > 0f) seen / alpha else 0f
        fragment.setColor(background.red * part, background.green * part, background.blue * part, alpha)
    }

    /** Returns 0 at the border of the raster, and 1 far enough from it. */
    private fun fading(x: Int, y: Int): Float {
        val columns = minOf(x, raster.width - 1 - x)
        val rows = minOf(y, raster.height - 1 - y)
        return fading(columns.toFloat() / side) * fading(rows.toFloat() / side)
    }

    private fun fading(distance: Float): Float {
        val part = minOf(maxOf((distance - BORDER) / (INNER - BORDER), 0f), 1f)
        return part * part * (3f - 2f * part)
    }

    private companion object {
        /** Where shadows end, as a part of the shorter side of the raster: inside the outermost pixels. */
        const val BORDER = 0.02f

        /** Distance from the border from which shadows are not faded, same unit: the margin of a product's picture. */
        const val INNER = 0.12f
    }
}
