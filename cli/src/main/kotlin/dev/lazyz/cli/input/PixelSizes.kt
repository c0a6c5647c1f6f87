package dev.lazyz.cli.input

import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface

/**
 * Sizes from the command line that replace those of the input.
 *
 * @property point size of points, pixels; null keeps the sizes of the input
 * @property line width of lines, pixels; null keeps the widths of the input
 */
internal class PixelSizes(private val point: Double?, private val line: Double?) {
    fun applyTo(scene: Scene): Scene {
        if (point == null && line == null) return scene
        return scene.withSurfaces(scene.surfaces.map { sized(it) })
    }

    private fun sized(surface: Surface): Surface = when {
        surface is Points && point != null -> surface.withSize(point)
        surface is Lines && line != null -> surface.withWidth(line)
        else -> surface
    }
}
