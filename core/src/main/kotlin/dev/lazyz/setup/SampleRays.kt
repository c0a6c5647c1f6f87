package dev.lazyz.setup

import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.unitAt

/**
 * The rays of a camera through the samples of a raster, in camera space (contract rule 2.6): `t (px, py, -1)` for
 * perspective and `(px, py, -t)` otherwise, where t is the distance from the eye along the line of sight. Immutable.
 */
internal class SampleRays(private val camera: Camera, private val viewport: Viewport) {
    val width: Int = viewport.raster.width
    val height: Int = viewport.raster.height
    val isPerspective: Boolean = camera.projection is Projection.Perspective
    private val isScreen = camera.projection == Projection.Screen
    private val halfHeight = camera.halfHeight()
    private val halfWidth = halfHeight * (width.toDouble() / height)

    /** How px changes to the next column. */
    val columnStep: Double = if (isScreen) 1.0 else 2.0 * halfWidth / width

    /** How py changes to the next row. */
    val rowStep: Double = if (isScreen) -1.0 else -2.0 * halfHeight / height

    fun px(x: Int): Double = if (isScreen) x + 0.5 else ((2 * x + 1).toDouble() / width - 1.0) * halfWidth

    fun py(y: Int): Double = if (isScreen) -(y + 0.5) else (1.0 - (2 * y + 1).toDouble() / height) * halfHeight

    /** Returns the column position, in pixels, at which [px] has the given value. */
    fun columnAt(px: Double): Double = if (isScreen) px else (1.0 + px / halfWidth) * 0.5 * width

    /** Returns the row position, in pixels, at which [py] has the given value. */
    fun rowAt(py: Double): Double = if (isScreen) -py else (1.0 - py / halfHeight) * 0.5 * height

    /** Returns the depth at the distance [t], in the raster's convention (contract rule 4.5). */
    fun depthAt(t: Double): Int = viewport.depthOfUnit(camera.unitAt(t))
}
