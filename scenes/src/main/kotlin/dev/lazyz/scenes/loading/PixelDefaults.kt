package dev.lazyz.scenes.loading

import dev.lazyz.Rgba
import dev.lazyz.world.Material

/** How points and lines of model files look, which say neither their size nor, mostly, their colour. */
internal object PixelDefaults {
    /** Size of points, pixels: looked at with clouds of 4 to 70,000 points at 512 x 512. */
    const val POINT_SIZE = 2.0

    /** Width of lines, pixels. */
    const val LINE_WIDTH = 1.0

    private val dark = Rgba.ofArgb(0xFF303840.toInt())

    /**
     * Returns the material of what the file has no colour for: dark if there is no light on it, for white would not be
     * seen on white; otherwise white, as meshes are.
     */
    fun material(isLit: Boolean, hasColors: Boolean, name: String = ""): Material =
        Material(if (isLit || hasColors) Rgba.WHITE else dark, name = name)
}
