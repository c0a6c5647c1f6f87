package dev.lazyz.scenes.loading

import dev.lazyz.Rgba
import dev.lazyz.world.material.Material

/** Appearance of points and lines of model files, which state neither their size nor, in most cases, their colour. */
internal object PixelDefaults {
    /** Size of points in pixels. Chosen by viewing clouds of 4 to 70,000 points at 512 x 512. */
    const val POINT_SIZE = 2.0

    /** Width of lines in pixels. */
    const val LINE_WIDTH = 1.0

    private val dark = Rgba.ofArgb(0xFF303840.toInt())

    /**
     * Returns the material for points or lines. Without light and without colours it is dark, because white would be
     * invisible on a white background; otherwise it is white, as for meshes.
     */
    fun material(isLit: Boolean, hasColors: Boolean, name: String = ""): Material =
        Material(if (isLit || hasColors) Rgba.WHITE else dark, name = name)
}
