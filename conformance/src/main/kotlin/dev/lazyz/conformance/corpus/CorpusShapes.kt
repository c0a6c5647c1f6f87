package dev.lazyz.conformance.corpus

import dev.lazyz.Depth
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.oracle.ExactPolygon
import dev.lazyz.conformance.oracle.ExactProjection
import dev.lazyz.geometry.FillRule
import dev.lazyz.scenes.Tint
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import org.joml.Vector3d
import org.joml.Vector3dc

/** Shapes of the corpus: polygons of the suite's frames on the grid, and what is made of them. */
internal object CorpusShapes {
    /** Returns the polygons of [case] on the grid: the first one, where the contract permits several. */
    fun polygons(case: FrameCase, raster: Raster): List<ExactPolygon> {
        val scene = checkNotNull(case.scene)
        val camera = scene.viewpoint as Camera
        if (!scene.isOnScreen) {
            val projection = ExactProjection(raster, camera)
            return outlines(scene.surfaces).flatMap { (contours, rule) ->
                projection.polygons(contours, rule).take(1).filterNotNull()
            }
        }
        return scene.surfaces.filterIsInstance<Polygon>().mapNotNull { polygon ->
            val contours = polygon.contours.map { contour ->
                contour.flatMap { listOf(snapped(it.x), snapped(it.y), Depth.ofUnit(it.z)) }.toIntArray()
            }
            val isDrawn = polygon.contours.flatten().all { (it.x + it.y + it.z).isFinite() }
            if (isDrawn && contours.sumOf { it.size } >= 9) ExactPolygon(contours, polygon.fillRule) else null
        }
    }

    private fun snapped(pixels: Double): Int = StrictMath.floor(256.0 * pixels + 0.5).toInt()

    private fun outlines(surfaces: List<Any>): List<Pair<List<List<Vector3dc>>, FillRule>> =
        surfaces.flatMap { surface ->
            when (surface) {
                is Polygon -> listOf(
                    surface.contours.map { contour -> contour.map { Vector3d(it.x, it.y, it.z) } } to
                        surface.fillRule,
                )

                is Mesh -> surface.triangles.toList().chunked(3).map { triangle ->
                    val corners = triangle.map {
                        val p = surface.positions
                        Vector3d(p[3 * it].toDouble(), p[3 * it + 1].toDouble(), p[3 * it + 2].toDouble())
                            .add(surface.origin)
                    }
                    listOf(corners) to FillRule.NON_ZERO
                }

                else -> emptyList()
            }
        }

    fun flat(polygons: List<ExactPolygon>): List<CorpusShape> =
        polygons.mapIndexed { i, it -> CorpusPolygon(it, CorpusColor.of(i)) }

    /** The first three vertices of each polygon, in one colour. */
    fun triangles(polygons: List<ExactPolygon>): List<CorpusShape> = flat(polygons.map(::triangle))

    private fun triangle(polygon: ExactPolygon): ExactPolygon {
        val all = polygon.contours.flatMap { it.asIterable() }
        return ExactPolygon(listOf(all.take(9).toIntArray()), FillRule.NON_ZERO)
    }

    /** The same triangles with a colour at each vertex; w is 1, or 1 to [most]. */
    fun mixed(polygons: List<ExactPolygon>, most: Int): List<CorpusShape> = polygons.mapIndexed { i, it ->
        val corners = List(3) { corner -> CorpusColor.of(i, corner + 1) }
        val ws = List(3) { corner -> 1 + Tint.hash(i, corner, 1, 0) % most }
        CorpusPolygon(triangle(it), CorpusColor.of(i), corners, ws)
    }

    /** Three of four polygons are translucent. */
    fun glass(polygons: List<ExactPolygon>): List<CorpusShape> = polygons.mapIndexed { i, it ->
        val alpha = if (i % 4 == 3) 255 else listOf(128, 64, 230)[i % 4]
        CorpusPolygon(it, CorpusColor.of(i, alpha = alpha))
    }

    /** A point, a line or a sphere at the first vertices of each polygon, near the raster. */
    private fun around(
        polygons: List<ExactPolygon>,
        shape: (x: List<Int>, size: Int, color: CorpusColor) -> CorpusShape,
    ): List<CorpusShape> = polygons.mapIndexed { i, it ->
        val numbers = it.contours.first().toList()
        shape(numbers.map { number -> number.coerceIn(-NEAR, NEAR) }, Tint.hash(i, 2, 0, 0), CorpusColor.of(i))
    }

    /** In grid steps: 30 pixels. */
    private const val NEAR = 30 * 256

    fun points(polygons: List<ExactPolygon>) = around(polygons) { numbers, size, color ->
        CorpusPoint(numbers[0], numbers[1], size % 16 / 16f, 128 + size % 900, color)
    }

    fun lines(polygons: List<ExactPolygon>) = around(polygons) { numbers, size, color ->
        val ends = listOf(numbers[0], numbers[1], numbers[3], numbers[4])
        CorpusLine(ends, listOf(size % 16 / 16f, size / 16 % 16 / 16f), 128 + size / 256 % 500, color)
    }

    fun spheres(polygons: List<ExactPolygon>) = around(polygons) { numbers, size, color ->
        CorpusSphere(numbers[0], numbers[1], 20 * 256 + size % 2560, 512 + size / 4096 % 2048, color)
    }
}
