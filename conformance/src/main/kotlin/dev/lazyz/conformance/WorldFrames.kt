package dev.lazyz.conformance

import dev.lazyz.AlphaMode
import dev.lazyz.Camera
import dev.lazyz.FillRule
import dev.lazyz.Material
import dev.lazyz.Mesh
import dev.lazyz.Polygon
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.Scene
import dev.lazyz.Shading
import dev.lazyz.Sides
import dev.lazyz.Sphere
import dev.lazyz.Surface
import dev.lazyz.Texture
import dev.lazyz.Vertex
import dev.lazyz.Viewpoint
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import org.joml.Vector3d

/** Generates frames of scenes: shapes within a few units of the origin, a camera among or before them. */
internal object WorldFrames {
    /** A value and the Kotlin expression for it. */
    class Coded<out T>(val value: T, val code: String)

    fun cases(rasters: Arbitrary<Raster>, maxSurfaces: Int): Arbitrary<FrameCase> =
        cases(rasters, listsOf(mixed(3 to polygon(), 2 to holed(), 3 to mesh(), 3 to sphere()), maxSurfaces))

    /** Frames of these surfaces. */
    fun cases(rasters: Arbitrary<Raster>, surfaces: Arbitrary<List<Coded<Surface>>>): Arbitrary<FrameCase> =
        Combinators.combine(rasters, surfaces, camera()).`as` { raster, list, camera ->
            val scene = Scene(list.map { it.value }, viewpoint = camera.value)
            val lines = list.joinToString("") { "\n        ${it.code}," }
            FrameCase(
                scene.frame(raster),
                "Scene(\n    listOf($lines\n    ),\n    viewpoint = ${camera.code},\n).frame(${code(raster)})",
                scene,
            )
        }

    private val coordinates: Arbitrary<Double> = mixed(
        80 to ints(-16, 16).map { it / 8.0 },
        9 to ints(-40, 40).map { it.toDouble() },
        1 to oneOf(1e30, Double.NaN, Double.POSITIVE_INFINITY),
    )

    private val points: Arbitrary<Vector3d> =
        Combinators.combine(coordinates, coordinates, coordinates).`as` { x, y, z -> Vector3d(x, y, z) }

    private fun camera(): Arbitrary<Coded<Viewpoint>> {
        val eyes = Combinators.combine(ints(-3, 3), ints(-3, 3), ints(1, 8))
            .`as` { x, y, z -> Vector3d(x.toDouble(), y.toDouble(), z.toDouble()) }
        return Combinators.combine(eyes, oneOf(40.0, 20.0, 120.0, 0.0)).`as` { eye, angle ->
            val line = "${code(eye)}, Vector3d(), Vector3d(0.0, 1.0, 0.0)"
            val up = Vector3d(0.0, 1.0, 0.0)
            if (angle > 0.0) {
                val camera = Camera.perspective(eye, Vector3d(), up, angle, 0.5, 10.0)
                Coded(camera, "Camera.perspective($line, $angle, 0.5, 10.0)")
            } else {
                val camera = Camera.orthographic(eye, Vector3d(), up, 4.0, 0.5, 10.0)
                Coded(camera, "Camera.orthographic($line, 4.0, 0.5, 10.0)")
            }
        }
    }

    private fun material(): Arbitrary<Coded<Material>> {
        val colors = ints(0, 0x1FF).map { Rgba((it and 7) / 8f, (it shr 3 and 7) / 8f, (it shr 6) / 8f, 0.75f) }
        val masks = oneOf(false, false, false, true)
        return Combinators.combine(colors, oneOf(*Shading.values()), oneOf(*Sides.values()), masks)
            .`as` { color, shading, sides, isMasked ->
                val texture = if (isMasked) Texture(2, 2, intArrayOf(-1, 0, 0, -256)) else null
                val mode = if (isMasked) AlphaMode.MASK else AlphaMode.OPAQUE
                val textureCode = if (isMasked) "Texture(2, 2, intArrayOf(-1, 0, 0, -256))" else "null"
                Coded(
                    Material(color, texture, shading, alphaMode = mode, sides = sides),
                    "Material(${code(color)}, $textureCode, Shading.$shading, " +
                        "alphaMode = AlphaMode.$mode, sides = Sides.$sides)",
                )
            }
    }

    fun polygon(): Arbitrary<Coded<Surface>> = Combinators
        .combine(points.list().ofMinSize(3).ofMaxSize(5), material())
        .`as` { contour, material -> polygon(listOf(contour), material) }

    /** A flat square with a triangular hole or island, at any height. */
    fun holed(): Arbitrary<Coded<Surface>> {
        val inner = Combinators.combine(ints(-12, 12), ints(-12, 12)).`as` { x, y -> Pair(x / 8.0, y / 8.0) }
        return Combinators.combine(inner.list().ofSize(3), ints(-16, 16), material()).`as` { hole, height, material ->
            val z = height / 8.0
            val square = listOf(-1.0 to -1.0, 1.0 to -1.0, 1.0 to 1.0, -1.0 to 1.0)
            polygon(listOf(square, hole).map { contour -> contour.map { (x, y) -> Vector3d(x, y, z) } }, material)
        }
    }

    private fun polygon(contours: List<List<Vector3d>>, material: Coded<Material>): Coded<Surface> {
        val vertices = contours.map { contour ->
            contour.map { Vertex(it.x, it.y, it.z, (it.x / 2).toFloat(), (it.y / 2).toFloat()) }
        }
        val code = vertices.joinToString(prefix = "listOf(", postfix = ")") { contour ->
            contour.joinToString(prefix = "listOf(", postfix = ")") {
                "Vertex(${code(it.x)}, ${code(it.y)}, ${code(it.z)}, ${code(it.u)}, ${code(it.v)})"
            }
        }
        return Coded(
            Polygon(vertices, material.value, FillRule.EVEN_ODD), "Polygon($code, ${material.code}, FillRule.EVEN_ODD)",
        )
    }

    fun mesh(): Arbitrary<Coded<Surface>> = Combinators
        .combine(points.list().ofMinSize(3).ofMaxSize(6), ints(0, 2).list().ofMinSize(1).ofMaxSize(6), material())
        .`as` { corners, turns, material ->
            // Neighbouring triangles share an edge, or cover each other
            val positions = corners.flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }
            val triangles = turns.flatMapIndexed { i, turn -> listOf(i, i + 1 + turn % 2, i + 2 - turn % 2) }
                .map { it % corners.size }
            Coded(
                Mesh(positions.toFloatArray(), triangles.toIntArray(), material.value),
                "Mesh(floatArrayOf(${positions.joinToString { code(it) }}), " +
                    "intArrayOf(${triangles.joinToString()}), ${material.code})",
            )
        }

    /** A triangle with a corner behind every camera there is: most reach across the near plane. */
    fun nearPlane(): Arbitrary<Coded<Surface>> {
        val front = Combinators.combine(ints(-8, 8), ints(-8, 8), ints(-8, 4))
            .`as` { x, y, z -> Vector3d(x / 8.0, y / 8.0, z / 8.0) }
        val behind = Combinators.combine(ints(-16, 16), ints(-16, 16))
            .`as` { x, y -> Vector3d(x / 8.0, y / 8.0, 40.0) }
        return Combinators.combine(front, oneOf(true, false), front, behind, material())
            .`as` { a, isBoth, b, c, material ->
                polygon(listOf(listOf(a, if (isBoth) Vector3d(b.x, b.y, 40.0) else b, c)), material)
            }
    }

    fun sphere(): Arbitrary<Coded<Surface>> = Combinators
        .combine(points, oneOf(0.5, 1.0, 0.05, 3.0, 0.0, Double.NaN), material())
        .`as` { center, radius, material ->
            Coded(
                Sphere(center, radius, material.value), "Sphere(${code(center)}, ${code(radius)}, ${material.code})",
            )
        }

    private fun code(v: Vector3d): String = "Vector3d(${code(v.x)}, ${code(v.y)}, ${code(v.z)})"

    private fun code(value: Float): String = when {
        value.isNaN() -> "Float.NaN"
        value.isInfinite() -> if (value > 0) "Float.POSITIVE_INFINITY" else "Float.NEGATIVE_INFINITY"
        else -> "${value}f"
    }
}
