package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
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
