package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Vertex
import org.joml.Vector3d

/** Three bars along the sides of a triangle. Each begins in front of the previous bar and ends behind the next. */
internal object CycleScene {
    private const val HALF_LENGTH = 1.3
    private const val HALF_WIDTH = 0.2
    private const val RISE = 0.45
    private const val DISTANCE = 0.5

    fun scene(): Scene = Scene(
        surfaces = listOf(
            bar(1.0, 0.0, Rgba.ofRgb(0xD9503F), "red"),
            bar(-0.5, SINE_OF_120, Rgba.ofRgb(0x3F9E63), "green"),
            bar(-0.5, -SINE_OF_120, Rgba.ofRgb(0x3B76C4), "blue"),
        ),
        lights = listOf(
            Light.Ambient(Rgba(0.30f, 0.30f, 0.32f)),
            Light.Directional(Vector3d(0.6, -0.8, -1.0), Rgba(0.75f, 0.74f, 0.70f)),
        ),
        viewpoint = Camera.fit(azimuth = 0.0, elevation = 0.0, kind = Fit.ORTHOGRAPHIC),
        background = Rgba.ofRgb(0xF4F1EA),
    )

    /**
     * Returns a bar in direction ([c], [s]) of the image plane, to the left of its middle, receding from the viewer.
     */
    private fun bar(c: Double, s: Double, color: Rgba, name: String): Polygon {
        fun corner(along: Double, across: Double): Vertex = Vertex(
            c * along - s * (across - DISTANCE),
            s * along + c * (across - DISTANCE),
            -RISE * along,
        )
        val contour = listOf(
            corner(-HALF_LENGTH, -HALF_WIDTH),
            corner(HALF_LENGTH, -HALF_WIDTH),
            corner(HALF_LENGTH, HALF_WIDTH),
            corner(-HALF_LENGTH, HALF_WIDTH),
        )
        return Polygon(listOf(contour), Material(color, shading = Shading.FLAT, name = name))
    }

    /** sqrt(3) / 2. */
    private const val SINE_OF_120 = 0.8660254037844386
}
