package dev.lazyz.world.surface

/**
 * A point on the raster. Immutable.
 *
 * @property x column position, pixels, a multiple of 1/256; the sample of column 0 is at 0.5
 * @property y row position, pixels, a multiple of 1/256; the sample of row 0 is at 0.5
 * @property depth depth, 0..2^31-1
 */
public class ScreenPoint internal constructor(public val x: Double, public val y: Double, public val depth: Int) {
    override fun toString(): String = "ScreenPoint($x, $y, depth $depth)"
}
