package dev.lazyz.scenes

import dev.lazyz.Rgba
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.drawing.EdgeStyle.EdgeSet
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.geometry.FillRule
import dev.lazyz.sections.Section
import dev.lazyz.sections.Section.Hatching
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d

/** Scenes for [GoldenTest] of points and lines, of edges, and of sections. */
internal object GoldenDrawings {
    private val camera = Camera.orthographic(
        Vector3d(3.0, 4.0, 6.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.4, 1.0, 20.0,
    )
    private val near = Camera.perspective(Vector3d(1.5, 2.5, 4.5), Vector3d(), Vector3d(0.0, 1.0, 0.0), 45.0, 1.0, 20.0)

    val all: Map<String, () -> Scene> = mapOf(
        "sparse" to { Scene(sparse(), viewpoint = near, background = Rgba(0.1f, 0.1f, 0.2f)) },
        "edges" to { drawn(EdgeStyle(width = 1.5, color = Rgba(0.4f, 0f, 0.1f)), near) },
        "edges-dashed" to { drawn(EdgeStyle(hidden = HiddenLines.DASHED, hiddenColor = Rgba.BLACK), camera) },
        "edges-solid" to {
            val solid = EdgeStyle(hidden = HiddenLines.SOLID, hiddenColor = Rgba.BLACK)
            drawn(solid.withCreaseAngle(10.0).withWidth(3.0), near)
        },
        "wireframe" to { drawn(EdgeStyle(EdgeSet.ALL, width = 0.7), near) },
        "section" to { section(Section(listOf(tilted))) },
        "section-hatched" to {
            val hatching = Hatching(0.3, 0.4, Rgba(0.1f, 0.1f, 0.3f), Rgba(0.9f, 0.9f, 0.7f))
            val planes = listOf(tilted, Section.Plane.x(0.3), Section.Plane.y(0.25))
            EdgeStyle(width = 1.2).drawnOn(section(Section(planes) { hatching.material() }))
        },
    )

    private val tilted = Section.Plane(Vector3d(0.3, 0.2, 1.0), 0.2)

    private fun drawn(style: EdgeStyle, viewpoint: Camera): Scene =
        style.drawnOn(Scene(solids(), viewpoint = viewpoint))

    private fun section(section: Section): Scene {
        val cut = section.of(Scene(solids() + sparse(), viewpoint = near))
        check(cut.scene.surfaces.count { it is Polygon } > 2) { "there must be caps: ${cut.warnings}" }
        return cut.scene
    }

    /** A ring, whose silhouettes are zigzags, a box through it, and a frame around both. */
    private fun solids(): List<Surface> {
        fun square(size: Double) = listOf(
            Vertex(-size, -size, -0.4), Vertex(size, -size, -0.4), Vertex(size, size, 0.3), Vertex(-size, size, 0.3),
        )
        val plain = Material(Rgba(0.8f, 0.9f, 0.7f), shading = Shading.CONSTANT)
        return listOf(
            ring(Material(Rgba(0.9f, 0.7f, 0.5f), shading = Shading.FLAT, sides = Sides.FRONT)),
            box(-0.3f, -0.5f, -1.6f, 0.4f, 0.4f, 1.5f, Material(Rgba(0.5f, 0.7f, 0.9f), shading = Shading.FLAT)),
            Polygon(listOf(square(2.0), square(1.8)), plain, FillRule.EVEN_ODD),
        )
    }

    /** A torus around the y axis. */
    private fun ring(material: Material): Mesh {
        val around = 14
        val across = 7
        val positions = FloatArray(3 * around * across) {
            val a = 2 * StrictMath.PI * (it / 3 / across) / around
            val b = 2 * StrictMath.PI * (it / 3 % across) / across
            val r = 1.1 + 0.4 * StrictMath.cos(b)
            when (it % 3) {
                0 -> r * StrictMath.cos(a)
                1 -> 0.4 * StrictMath.sin(b)
                else -> -r * StrictMath.sin(a)
            }.toFloat()
        }
        val triangles = IntArray(6 * around * across) {
            val quad = it / 6
            val next = quad / across * across + (quad + 1) % across
            val other = (quad / across + 1) % around * across
            intArrayOf(quad, other + quad % across, other + next % across, quad, other + next % across, next)[it % 6]
        }
        return Mesh(positions, triangles, material)
    }

    private fun box(x0: Float, y0: Float, z0: Float, x1: Float, y1: Float, z1: Float, material: Material): Mesh {
        val positions = FloatArray(24) {
            val isHigh = it / 3 shr it % 3 and 1 == 1
            if (isHigh) floatArrayOf(x1, y1, z1)[it % 3] else floatArrayOf(x0, y0, z0)[it % 3]
        }
        val quads = intArrayOf(0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5)
        val triangles = IntArray(36) { quads[it / 6 * 4 + intArrayOf(0, 1, 2, 0, 2, 3)[it % 6]] }
        return Mesh(positions, triangles, material)
    }

    /** Points with and without normals, and wide and narrow lines. */
    private fun sparse(): List<Surface> {
        val count = 40
        val positions = FloatArray(3 * count) {
            ((it * it * 37 + it * 11) % 101 / 50.0 - 1.0).toFloat()
        }
        val colors = FloatArray(4 * count) { if (it % 4 == 3) 1f else (it * 29 % 31) / 30f }
        return listOf(
            Points(positions, 2.5, Material(), positions, colors),
            Points(FloatArray(3 * count) { -positions[it] }, 1.0, Material(Rgba(1f, 0.6f, 0.2f))),
            Lines(positions, IntArray(count) { it }, 1.7, Material(), colors),
            Lines(FloatArray(3 * count) { positions[it] / 2 }, IntArray(2 * count - 2) { (it + 1) / 2 }, 0.3),
        )
    }
}
