package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d

/** Three large triangles around the origin, one perpendicular to each axis. */
internal object CrossingScene {
    fun scene(): Scene = Scene(
        surfaces = listOf(
            triangle(0, Rgba.ofRgb(0xE0A030), "yellow"),
            triangle(1, Rgba.ofRgb(0xC0405A), "red"),
            triangle(2, Rgba.ofRgb(0x3A7FB5), "blue"),
        ),
        lights = listOf(
            Light.Ambient(Rgba(0.25f, 0.25f, 0.27f)),
            Light.Directional(Vector3d(0.4, -1.0, -0.65), Rgba(0.80f, 0.78f, 0.74f)),
            Light.Directional(Vector3d(-1.0, -0.2, -0.3), Rgba(0.50f, 0.50f, 0.50f)),
        ),
        viewpoint = Camera.fit(azimuth = 38.0, elevation = 36.0),
        background = Rgba.ofRgb(0xF2F0EB),
    )

    /** Returns an equilateral triangle of radius 1 about the origin, perpendicular to the axis with number [axis]. */
    private fun triangle(axis: Int, color: Rgba, name: String): Mesh {
        val corners = doubleArrayOf(0.0, 1.0, -HALF_SIDE, -0.5, HALF_SIDE, -0.5)
        val positions = FloatArray(9) {
            when (it % 3) {
                (axis + 1) % 3 -> corners[it / 3 * 2].toFloat()
                (axis + 2) % 3 -> corners[it / 3 * 2 + 1].toFloat()
                else -> 0f
            }
        }
        return Mesh(positions, intArrayOf(0, 1, 2), Material(color, shading = Shading.FLAT, name = name))
    }

    /** sqrt(3) / 2. */
    private const val HALF_SIDE = 0.8660254037844386
}
