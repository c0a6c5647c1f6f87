package dev.lazyz.scenes

import dev.lazyz.Raster
import dev.lazyz.world.Scene

/**
 * A scene that was read, and what the reader had to pass over.
 *
 * @property scene what the file holds, with its own camera and lights where it has them
 * @property warnings one sentence each, in the order of the file: a texture that is missing, a face that was left out
 * @property size how large the file wants its picture, or null if it does not say; only scene files do
 * @property depth how depths are to be compared; only scene files say other than usual
 */
public class LoadedScene @JvmOverloads constructor(
    public val scene: Scene,
    public val warnings: List<String>,
    public val size: ImageSize? = null,
    public val depth: DepthRules = DepthRules(),
) {
    /**
     * Returns the raster to set the scene up for, `scene.frame(raster(...))`: its background, and the file's rules of
     * depth.
     *
     * @throws IllegalArgumentException if a side is out of range
     */
    public fun raster(width: Int, height: Int): Raster = depth.raster(width, height, scene.background)

    override fun toString(): String = "LoadedScene($scene, ${warnings.size} warnings, size $size)"
}

/**
 * Columns and rows of a picture. Immutable.
 *
 * @property width number of columns, 1..[Raster.MAX_SIDE]
 * @property height number of rows, 1..[Raster.MAX_SIDE]
 * @throws IllegalArgumentException if a side is out of range
 */
public class ImageSize(public val width: Int, public val height: Int) {
    init {
        require(width in 1..Raster.MAX_SIDE) { "width must be in 1..${Raster.MAX_SIDE}: $width" }
        require(height in 1..Raster.MAX_SIDE) { "height must be in 1..${Raster.MAX_SIDE}: $height" }
    }

    override fun equals(other: Any?): Boolean = other is ImageSize && width == other.width && height == other.height

    override fun hashCode(): Int = width * 31 + height

    override fun toString(): String = "${width}x$height"
}
