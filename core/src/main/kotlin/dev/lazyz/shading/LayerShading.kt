package dev.lazyz.shading

import dev.lazyz.Blending
import dev.lazyz.DepthTest
import dev.lazyz.Frame

/**
 * Computes the colour of a sample from its translucent fragments and the opaque one behind them (contract rule 5.5),
 * once their order is known. Fragments are shaded from the nearest on, and only as long as light passes.
 *
 * Used by one thread.
 */
internal class LayerShading(private val frame: Frame, private val shading: LateShading) {
    private val blending = Blending()
    private val background = frame.raster.background
    private val backgroundArgb = background.toArgb()

    /**
     * Returns the colour, `0xAARRGGBB`, of a sample at which the first [count] primitives of [layers] are visible, from
     * near to far, before the opaque primitive [backdrop], or before the background. Within a row, columns must not
     * decrease.
     */
    fun shade(x: Int, y: Int, layers: IntArray, count: Int, backdrop: Int): Int = when {
        count > 0 -> blending.blend(count, backdrop != DepthTest.BACKGROUND, background) { i ->
            val index = if (i < count) layers[i] else backdrop
            shading.shaded(x, y, index, frame.primitives[index])
        }
        backdrop == DepthTest.BACKGROUND -> backgroundArgb
        else -> shading.shade(x, y, backdrop)
    }
}
