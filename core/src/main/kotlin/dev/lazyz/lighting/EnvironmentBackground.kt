package dev.lazyz.lighting

import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.filter.PixelBackground
import dev.lazyz.filter.composited
import dev.lazyz.shading.ToneMapper
import dev.lazyz.shading.pbr.EnvironmentView
import dev.lazyz.shading.pbr.PhysicalSurface
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection

/**
 * The environment of a scene behind its pixels, as its camera sees it and smooth metal shows it, with the same exposure
 * and tone curve (contract rule 6.17). All rays of an orthographic camera are parallel, so it shows one colour.
 *
 * ```
 * val frame = scene.frame(Raster(640, 480, Rgba.TRANSPARENT))
 * renderer.render(frame, EnvironmentBackground(scene, 640, 480).behind(frame.region, 480, sink))
 * ```
 *
 * Immutable and thread safe. Cost: some 50 ns for each part of a pixel that is not opaque; no memory.
 *
 * @param scene the scene; its viewpoint chooses the camera
 * @property width columns of the whole picture
 * @param height rows of the whole picture
 * @property factor a pixel has the mean colour of [factor] x [factor] points
 * @throws IllegalArgumentException if a number is below 1, or the scene is given on the screen
 */
public class EnvironmentBackground @JvmOverloads constructor(
    scene: Scene,
    public val width: Int,
    height: Int,
    public val factor: Int = 4,
) : PixelBackground {
    private val camera: Camera = scene.camera(width, height)
    private val environment = EnvironmentView.of(scene.effectiveEnvironment, camera)
    private val toneMapper = ToneMapper.of(scene.effectiveToneMapping)

    init {
        require(factor >= 1) { "factor must be at least 1: $factor" }
        require(camera.projection != Projection.Screen) { "a scene given on the screen has no surroundings" }
    }

    override fun behind(region: Region, height: Int, sink: RowSink): RowSink {
        require(region.rowEnd <= height) { "$region must be within $height rows" }
        val point = Point(height)
        return RowSink { y, argb, depth, primitive ->
            for (x in 0 until region.width) {
                if (argb[x] ushr 24 != 0xFF) argb[x] = composited(argb[x], point.pixel(region.columnStart + x, y))
            }
            sink.row(y, argb, depth, primitive)
        }
    }

    /** The colours of pixels, one after the other. */
    private inner class Point(height: Int) {
        private val surface = FloatArray(PhysicalSurface.SIZE)
        private val color = FloatArray(3)
        private val light = DoubleArray(3)
        private val isPerspective = camera.projection is Projection.Perspective
        private val across = if (isPerspective) camera.halfHeight() * width / height else 0.0
        private val upward = if (isPerspective) camera.halfHeight() else 0.0
        private val rows = height.toDouble() * factor

        fun pixel(x: Int, y: Int): DoubleArray {
            light.fill(0.0)
            for (row in 0 until factor) {
                for (column in 0 until factor) {
                    val right = 2.0 * (x.toDouble() * factor + column + 0.5) / (width.toDouble() * factor) - 1.0
                    val up = 1.0 - 2.0 * (y.toDouble() * factor + row + 0.5) / rows
                    look(right * across, up * upward)
                    for (channel in 0 until 3) light[channel] += minOf(maxOf(color[channel], 0f), 1f).toDouble()
                }
            }
            for (channel in 0 until 3) light[channel] /= factor.toDouble() * factor
            return light
        }

        private fun look(right: Double, up: Double) {
            val d = camera.toWorldDirection(right, up, -1.0)
            val length = StrictMath.sqrt(d.x * d.x + d.y * d.y + d.z * d.z)
            surface.fill(0f, PhysicalSurface.RADIANCE, PhysicalSurface.RADIANCE + 3)
            environment?.radiance(
                (d.x / length).toFloat(), (d.y / length).toFloat(), (d.z / length).toFloat(), 0f, surface,
            )
            surface.copyInto(color, 0, PhysicalSurface.RADIANCE, PhysicalSurface.RADIANCE + 3)
            toneMapper?.apply(color)
        }
    }

    override fun toString(): String = "EnvironmentBackground($width columns, $camera)"
}
