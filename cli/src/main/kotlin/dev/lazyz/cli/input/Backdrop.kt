package dev.lazyz.cli.input

import dev.lazyz.Rgba
import dev.lazyz.filter.VerticalGradient

/**
 * What is behind the surfaces.
 *
 * @property color the background of the frame; transparent if there is a gradient
 * @property gradient the gradient, or null
 */
internal class Backdrop private constructor(val color: Rgba, val gradient: VerticalGradient?) {
    constructor(color: Rgba) : this(color, null)

    constructor(gradient: VerticalGradient) : this(Rgba.TRANSPARENT, gradient)
}
