package dev.lazyz.conformance.frames.world

import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.geometry.FillRule
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import org.joml.Vector3d

/** Generates polygons and spheres in world space. */
internal class WorldShapes(private val materials: Arbitrary<Coded<Material>>) {
    fun polygon(): Arbitrary<Coded<Surface>> = Combinators
        .combine(points.list().ofMinSize(3).ofMaxSize(5), paint(), materials)
        .`as` { contour, paint, material -> coded(listOf(contour), paint, material) }

    /** Generates a flat square with a triangular hole or island, at any z. */
    fun holed(): Arbitrary<Coded<Surface>> {
        val inner = Combinators.combine(ints(-12, 12), ints(-12, 12)).`as` { x, y -> Pair(x / 8.0, y / 8.0) }
        return Combinators.combine(inner.list().ofSize(3), ints(-16, 16), oneOf(1.0, 2.0), paint(), materials)
            .`as` { hole, height, half, paint, material ->
                val z = height / 8.0
                val square = listOf(-half to -half, half to -half, half to half, -half to half)
                val contours = listOf(square, hole).map { contour -> contour.map { (x, y) -> Vector3d(x, y, z) } }
                coded(contours, paint, material)
            }
    }

    /** Generates a triangle with a vertex behind every generated camera, so that most reach across the near plane. */
    fun nearPlane(): Arbitrary<Coded<Surface>> {
        val front = Combinators.combine(ints(-8, 8), ints(-8, 8), ints(-8, 4))
            .`as` { x, y, z -> Vector3d(x / 8.0, y / 8.0, z / 8.0) }
        val behind = Combinators.combine(ints(-16, 16), ints(-16, 16))
            .`as` { x, y -> Vector3d(x / 8.0, y / 8.0, 40.0) }
        return Combinators.combine(front, oneOf(true, false), front, behind, paint(), materials)
            .`as` { a, isBoth, b, c, paint, material ->
                coded(listOf(listOf(a, if (isBoth) Vector3d(b.x, b.y, 40.0) else b, c)), paint, material)
            }
    }

    fun sphere(): Arbitrary<Coded<Surface>> {
        val radii = mixed(16 to oneOf(0.5, 1.0, 1.5, 3.0), 2 to oneOf(0.05), 1 to oneOf(0.0, Double.NaN))
        return Combinators.combine(mixed(9 to centers, 1 to points), radii, materials)
            .`as` { center, radius, material ->
                Coded(
                    Sphere(center, radius, material.value),
                    "Sphere(${code(center)}, ${code(radius)}, ${material.code})",
                )
            }
    }

    /** The vertex colours, which repeat along the vertices, and the number of repetitions of a texture per unit. */
    private class Paint(val colors: List<Rgba>, val scale: Double)

    private fun paint(): Arbitrary<Paint> = Combinators.combine(
        mixed(1 to Arbitraries.just(listOf(Rgba.WHITE)), 3 to WorldMaterials.colors.list().ofMinSize(1).ofMaxSize(3)),
        oneOf(0.5, 0.25, 2.0, 20.0),
    ).`as`(::Paint)

    private fun coded(contours: List<List<Vector3d>>, paint: Paint, material: Coded<Material>): Coded<Surface> {
        var number = 0
        val vertices = contours.map { contour ->
            contour.map {
                val color = paint.colors[number++ % paint.colors.size]
                Vertex(it.x, it.y, it.z, (it.x * paint.scale).toFloat(), (it.y * paint.scale).toFloat(), color)
            }
        }
        val code = vertices.joinToString(prefix = "listOf(", postfix = ")") { contour ->
            contour.joinToString(prefix = "listOf(", postfix = ")") { vertex(it) }
        }
        return Coded(
            Polygon(vertices, material.value, FillRule.EVEN_ODD), "Polygon($code, ${material.code}, FillRule.EVEN_ODD)",
        )
    }

    private fun vertex(it: Vertex): String {
        val color = if (it.color == Rgba.WHITE) "" else ", ${code(it.color)}"
        return "Vertex(${code(it.x)}, ${code(it.y)}, ${code(it.z)}, ${code(it.u)}, ${code(it.v)}$color)"
    }

    companion object {
        private val eighths: Arbitrary<Double> = ints(-16, 16).map { it / 8.0 }
        private val far: Arbitrary<Double> = ints(-40, 40).map { it.toDouble() }
        private val wild: Arbitrary<Double> = oneOf(1e30, Double.NaN, Double.POSITIVE_INFINITY)

        /** Mostly near the origin, sometimes far away, rarely not finite or huge. */
        val points: Arbitrary<Vector3d> = mixed(
            280 to point(eighths, eighths),
            10 to point(far, far),
            1 to point(wild, eighths),
        )

        /** Near the origin. */
        val centers: Arbitrary<Vector3d> = ints(-8, 8).map { it / 8.0 }.let { point(it, it) }

        private fun point(first: Arbitrary<Double>, others: Arbitrary<Double>): Arbitrary<Vector3d> =
            Combinators.combine(first, others, others).`as` { x, y, z -> Vector3d(x, y, z) }
    }
}
