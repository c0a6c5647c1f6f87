package dev.lazyz.setup

import dev.lazyz.Raster
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Vertices
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.unitAt

/**
 * Converts clip space to the grid of the raster. This is the only place where vertices are rounded (contract rules 1.3
 * and 4.2).
 */
internal open class Viewport(val raster: Raster) {
    /** Returns the extent in x, as a multiple of w, of a guard band that ends [pixels] from the raster's origin. */
    open fun guardX(pixels: Int): Double = 2.0 * pixels / raster.width - 1.0

    /** Same in y, see [guardX]. */
    open fun guardY(pixels: Int): Double = 2.0 * pixels / raster.height - 1.0

    /** z of the near plane, as a multiple of w. */
    open val near: Double = -1.0

    /** Returns the column position of a vertex on the 1/256 pixel grid. */
    fun gridX(vertices: Vertices, vertex: Int): Int =
        gridX(vertices.get(vertex, Vertices.X), vertices.get(vertex, Vertices.W))

    /** As [gridX], for a vertex with this x and w in clip space. */
    open fun gridX(x: Double, w: Double): Int = ScreenGrid.snap((x / w + 1.0) * 0.5 * raster.width)

    /** Returns the row position of a vertex on the 1/256 pixel grid. */
    fun gridY(vertices: Vertices, vertex: Int): Int =
        gridY(vertices.get(vertex, Vertices.Y), vertices.get(vertex, Vertices.W))

    /** As [gridY], for a vertex with this y and w in clip space. */
    open fun gridY(y: Double, w: Double): Int = ScreenGrid.snap((1.0 - y / w) * 0.5 * raster.height)

    /** Returns the depth of a vertex. */
    fun depth(vertices: Vertices, vertex: Int): Int =
        depth(vertices.get(vertex, Vertices.Z), vertices.get(vertex, Vertices.W))

    /** As [depth], for a vertex with this z and w in clip space. */
    open fun depth(z: Double, w: Double): Int = depthOfUnit((z / w + 1.0) * 0.5)

    /**
     * Returns the depth at the fraction [unit] of the distance from near (0) to far (1), in the raster's convention.
     */
    fun depthOfUnit(unit: Double): Int = raster.convention.ofUnit(unit)

    companion object {
        /** Returns the viewport that maps the clip space of [camera] to [raster]. */
        fun of(raster: Raster, camera: Camera): Viewport =
            if (camera.projection == Projection.Screen) ScreenViewport(raster) else Viewport(raster)
    }
}

/**
 * The viewport of a screen camera: x and y are pixels, z is the fraction of the distance from near to far, and w is 1.
 */
private class ScreenViewport(raster: Raster) : Viewport(raster) {
    override val near: Double get() = 0.0

    override fun guardX(pixels: Int): Double = pixels.toDouble()

    override fun guardY(pixels: Int): Double = pixels.toDouble()

    override fun gridX(x: Double, w: Double): Int = ScreenGrid.snap(x)

    override fun gridY(y: Double, w: Double): Int = ScreenGrid.snap(y)

    override fun depth(z: Double, w: Double): Int = depthOfUnit(z)
}

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
