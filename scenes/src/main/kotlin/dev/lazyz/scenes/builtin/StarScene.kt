package dev.lazyz.scenes.builtin

import dev.lazyz.FillRule
import dev.lazyz.Rgba
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Vertex
import org.joml.Vector3d

/**
 * A star with a round hole (even-odd rule), and behind it a star that crosses itself, with a filled middle (non-zero
 * rule).
 */
internal object StarScene {
    fun scene(): Scene = Scene(
        surfaces = listOf(
            Polygon(
                listOf(star(), circle(0.28, 24)),
                Material(Rgba.ofRgb(0xE3A62F), shading = Shading.FLAT, name = "gold"),
                FillRule.EVEN_ODD,
            ),
            Polygon(
                listOf(stroke()),
                Material(Rgba.ofRgb(0x3A62A8), shading = Shading.FLAT, name = "blue"),
                FillRule.NON_ZERO,
            ),
        ),
        lights = listOf(
            Light.Ambient(Rgba(0.30f, 0.30f, 0.32f)),
            Light.Directional(Vector3d(0.5, -0.5, -1.0), Rgba(0.78f, 0.76f, 0.72f)),
        ),
        viewpoint = Camera.fit(azimuth = 18.0, elevation = 12.0),
        background = Rgba.ofRgb(0xF3EFE6),
    )

    /** Returns ten corners, outer and inner ones alternating. */
    private fun star(): List<Vertex> = List(10) { at(0.5 + it / 10.0, if (it % 2 == 0) 1.0 else 0.45, 0.0) }

    private fun circle(radius: Double, corners: Int): List<Vertex> = List(corners) {
        at(it / corners.toDouble(), radius, 0.0)
    }

    /** Returns five corners, each joined to the corner after the next. */
    private fun stroke(): List<Vertex> = List(5) { at(2 * it / 5.0, 1.25, -0.35) }

    /** Returns the point at [turn] of a full turn, counter-clockwise from the top. */
    private fun at(turn: Double, radius: Double, z: Double): Vertex {
        val angle = turn * 2.0 * StrictMath.PI
        return Vertex(-radius * StrictMath.sin(angle), radius * StrictMath.cos(angle), z)
    }
}
