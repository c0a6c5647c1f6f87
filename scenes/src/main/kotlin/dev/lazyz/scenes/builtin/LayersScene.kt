package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d

/** A twisted stack of squares, the lowest first. */
internal object LayersScene {
    private const val MAX_COUNT = 100_000
    private const val HEIGHT = 1.9

    fun scene(count: Int): Scene {
        require(count in 1..MAX_COUNT) { "count must be in 1..$MAX_COUNT: $count" }
        return Scene(
            surfaces = List(count) { layer(if (count == 1) 0.0 else it / (count - 1.0)) },
            lights = listOf(
                Light.Ambient(Rgba(0.35f, 0.35f, 0.37f)),
                Light.Directional(Vector3d(0.3, -1.0, -0.6), Rgba(0.72f, 0.70f, 0.66f)),
            ),
            viewpoint = Camera.fit(azimuth = 20.0, elevation = 48.0),
            background = Rgba.ofRgb(0x20242C),
        )
    }

    /**
     * Returns the layer at [height], 0..1: a square rotated by [height] times 180 degrees, slightly smaller than the
     * one below.
     */
    private fun layer(height: Double): Mesh {
        val angle = height * StrictMath.PI
        val radius = 1.3 - 0.5 * height
        val c = radius * StrictMath.cos(angle)
        val s = radius * StrictMath.sin(angle)
        val y = (HEIGHT * height).toFloat()
        val positions = floatArrayOf(
            c.toFloat(), y, s.toFloat(),
            s.toFloat(), y, -c.toFloat(),
            -c.toFloat(), y, -s.toFloat(),
            -s.toFloat(), y, c.toFloat(),
        )
        return Mesh(positions, intArrayOf(0, 1, 2, 0, 2, 3), Material(color(height), shading = Shading.FLAT))
    }

    /**
     * Returns a colour from violet over blue, green and yellow to red: one cosine wave per component, 120 degrees
     * apart.
     */
    private fun color(height: Double): Rgba {
        val hue = (0.78 - 0.78 * height) * 2.0 * StrictMath.PI
        fun wave(shift: Double): Float = (0.45 + 0.40 * StrictMath.cos(hue - shift)).toFloat()
        return Rgba(wave(0.0), wave(2.0 * StrictMath.PI / 3.0), wave(4.0 * StrictMath.PI / 3.0))
    }
}
