package dev.lazyz.conformance.frames.world

import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/** Generates clouds of points, and lines between points. Sizes are from less than a pixel to more than a tile. */
internal class WorldPoints(private val materials: Arbitrary<Coded<Material>>) {
    private val sizes: Arbitrary<Double> =
        mixed(4 to oneOf(1.0, 2.0, 3.0), 2 to oneOf(0.25, 1.5, 5.3), 1 to oneOf(24.0))

    fun points(): Arbitrary<Coded<Surface>> = Combinators
        .combine(positions(1), sizes, materials, WorldAttributes.any()).`as` { positions, size, material, attributes ->
            val normals = attributes.normals(positions)
            val colors = attributes.colors(positions)
            val words = listOfNotNull(
                code(positions), code(size), material.code, normals?.let { "normals = ${code(it)}" },
                colors?.let { "colors = ${code(it)}" },
            )
            Coded(
                Points(positions, size, material.value, normals, colors), words.joinToString(", ", "Points(", ")"),
            )
        }

    /** Mostly polylines, otherwise arbitrary segments, including segments of length zero. */
    fun lines(): Arbitrary<Coded<Surface>> = Combinators
        .combine(positions(2), ints(0, 5).list().ofMinSize(1).ofMaxSize(8), sizes, materials, WorldAttributes.any())
        .`as` { positions, turns, width, material, attributes ->
            val count = positions.size / 3
            val segments = turns.flatMapIndexed { i, turn ->
                val first = i % count
                listOf(first, if (turn < 4) (first + 1) % count else (first + turn) % count)
            }.toIntArray()
            val colors = attributes.colors(positions)
            val words = listOfNotNull(
                code(positions), "intArrayOf(${segments.joinToString()})", code(width), material.code,
                colors?.let { "colors = ${code(it)}" },
            )
            Coded(Lines(positions, segments, width, material.value, colors), words.joinToString(", ", "Lines(", ")"))
        }

    private fun positions(least: Int): Arbitrary<FloatArray> =
        WorldShapes.points.list().ofMinSize(least).ofMaxSize(12).map { list ->
            list.flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }.toFloatArray()
        }
}
