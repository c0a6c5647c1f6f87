package dev.lazyz.setup

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader

/**
 * Builds a frame from primitives that are defined in screen space, without a scene or a camera: for tests, diagrams and
 * 2D drawing.
 *
 * A vertex is three numbers: x and y in pixels (the sample of pixel (0, 0) is at (0.5, 0.5)), and depth from 0 (near)
 * to 1 (far). Depth is clamped to 0..1. Vertices are snapped like all others. The only attribute is the position on the
 * screen, in [Fragment.worldX], [Fragment.worldY] and [Fragment.worldZ]. Not thread safe.
 */
public class FrameBuilder(private val raster: Raster) {
    private val viewport = Viewport(raster)
    private val primitives = ArrayList<Primitive>()

    /** Adds a custom primitive after those already added. */
    public fun add(primitive: Primitive): FrameBuilder = apply { primitives.add(primitive) }

    /**
     * Adds a polygon. It is treated as opaque, whatever alpha [shader] sets.
     *
     * The arrays are copied, and can be changed afterwards.
     *
     * @param contours x, y, depth triples for each closed contour; with a vertex that is NaN or infinite, the polygon
     *   covers nothing
     * @throws IllegalArgumentException if a contour does not consist of triples, or a vertex is more than 2^19 pixels
     *   from the origin
     */
    public fun polygon(shader: Shader, fillRule: FillRule, vararg contours: DoubleArray): FrameBuilder = apply {
        add(shader, fillRule, contours.asList(), isTranslucent = false)
    }

    /**
     * Adds a polygon of one contour, convex or concave, in one [color]. It is translucent if the alpha of the colour is
     * below 1. The array is copied, and can be changed afterwards. Throws like the other [polygon].
     */
    public fun polygon(color: Rgba, contour: DoubleArray): FrameBuilder = apply {
        val shader = Shader { it.setColor(color.red, color.green, color.blue, color.alpha) }
        add(shader, FillRule.NON_ZERO, listOf(contour), isTranslucent = !(color.alpha >= 1f))
    }

    /** Returns the frame so far. The builder can be used further. */
    public fun build(): Frame = Frame(raster, primitives.toList())

    private fun add(shader: Shader, fillRule: FillRule, contours: List<DoubleArray>, isTranslucent: Boolean) {
        primitives.add(primitive(shader, fillRule, contours.filter { it.isNotEmpty() }, isTranslucent).orEmpty())
    }

    private fun primitive(
        shader: Shader,
        fillRule: FillRule,
        contours: List<DoubleArray>,
        isTranslucent: Boolean,
    ): Primitive? {
        for (contour in contours) {
            require(contour.size % 3 == 0) { "a contour must be x, y, depth triples: ${contour.size} numbers" }
        }
        val all = contours.flatMap { it.asIterable() }
        if (all.any { !it.isFinite() } || all.size < 9) return null
        val count = all.size / 3
        val vertices = Vertices(count)
        for (i in 0 until count) {
            require(isInGuardBand(all[3 * i]) && isInGuardBand(all[3 * i + 1])) {
                "a vertex must be within ${ScreenGrid.GUARD} pixels of the origin: (${all[3 * i]}, ${all[3 * i + 1]})"
            }
            vertices.set(i, Vertices.W, 1.0)
            for (k in 0 until 3) vertices.set(i, Vertices.WORLD + k, all[3 * i + k])
        }
        var end = 0
        val ends = contours.map { contour -> (end + contour.size / 3).also { end = it } }.toIntArray()
        val assembly = PrimitiveAssembly(
            vertices,
            IntArray(count) { it },
            ends,
            IntArray(count) { ScreenGrid.snap(all[3 * it]) },
            IntArray(count) { ScreenGrid.snap(all[3 * it + 1]) },
            IntArray(count) { viewport.depthOfUnit(all[3 * it + 2]) },
        )
        return assembly.primitive(raster, fillRule, shader, Attributes.WORLD, 1.0, isTranslucent)
    }

    private fun isInGuardBand(pixels: Double): Boolean = StrictMath.abs(pixels) <= ScreenGrid.GUARD
}
