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

    private fun triangle(polygon: ExactPolygon, changed: (index: Int, number: Int) -> Int): ExactPolygon {
        val numbers = triangle(polygon).contours.single()
        val contour = IntArray(9) { if (it % 3 == 2) numbers[it] else changed(it, numbers[it]) }
        return ExactPolygon(listOf(contour), FillRule.NON_ZERO)
    }

    /** The same triangles with vertices at 16ths of pixels. */
    fun coarse(polygons: List<ExactPolygon>): List<CorpusShape> =
        flat(polygons.map { polygon -> triangle(polygon) { _, number -> Math.floorDiv(number + 8, 16) * 16 } })

    /** The same triangles in dark colours, of which an encoding by another curve is seen. */
    fun dark(polygons: List<ExactPolygon>): List<CorpusShape> =
        polygons.mapIndexed { i, it -> CorpusPolygon(triangle(it), CorpusColor.of(i, few = DARK)) }

    /** The same triangles, as large as the guard band around the middle of their first side. */
    fun large(polygons: List<ExactPolygon>): List<CorpusShape> = flat(polygons.map(::enlarged))

    private fun enlarged(polygon: ExactPolygon): ExactPolygon {
        val all = triangle(polygon).contours.single()
        val middle = List(2) { (all[it] + all[it + 3]) / 2 }
        val reach = all.indices.filter { it % 3 != 2 }.maxOf { StrictMath.abs(all[it] - middle[it % 3]) }
        if (reach == 0 || middle.any { it !in -NEAR..NEAR }) return polygon
        val factor = (GUARD_BAND - NEAR) / reach
        return triangle(polygon) { i, number -> middle[i % 3] + factor * (number - middle[i % 3]) }
    }

    /** The same triangles with a colour at each vertex; w is 1, or 1 to [most]. */
    fun mixed(polygons: List<ExactPolygon>, most: Int): List<CorpusShape> =
        polygons.mapIndexed { i, it -> mixed(i, it, most, listOf(255)) }

    private fun mixed(index: Int, polygon: ExactPolygon, most: Int, alphas: List<Int>): CorpusPolygon {
        val numbers = List(3) { corner -> Tint.hash(index, corner, 1, 0) }
        val corners = numbers.mapIndexed { i, it -> CorpusColor.of(index, i + 1, alphas[it / 8 % alphas.size]) }
        val color = CorpusColor.of(index, alpha = corners.minOf { it.alpha })
        return CorpusPolygon(triangle(polygon), color, corners, numbers.map { 1 + it % most })
    }

    /** Three of four polygons are translucent. */
    fun glass(polygons: List<ExactPolygon>): List<CorpusShape> =
        polygons.mapIndexed { i, it -> CorpusPolygon(it, CorpusColor.of(i, alpha = listOf(128, 64, 230, 255)[i % 4])) }

    fun points(polygons: List<ExactPolygon>) = polygons.mapIndexed { i, it -> point(i, it) }

    fun lines(polygons: List<ExactPolygon>) = polygons.mapIndexed { i, it -> line(i, it) }

    fun spheres(polygons: List<ExactPolygon>) = polygons.mapIndexed { i, it -> sphere(i, it) }

    /** Translucent shapes of all kinds; spheres, whose depths have another scale, are alone. */
    fun allKinds(polygons: List<ExactPolygon>): List<CorpusShape> {
        val areSpheres = polygons.isNotEmpty() && size(0, near(polygons[0])) % 4 == 0
        return polygons.mapIndexed { i, it ->
            val size = size(i, near(it)) / 4
            val alpha = ALPHAS[size % ALPHAS.size]
            if (areSpheres) return@mapIndexed sphere(i, it, alpha)
            when (size / 8 % 4) {
                0 -> mixed(i, it, 8, ALPHAS)
                1 -> point(i, it, alpha)
                2 -> line(i, it, alpha)
                else -> CorpusPolygon(it, CorpusColor.of(i, alpha = alpha))
            }
        }
    }

    /** The numbers of the first contour: those of vertices near the raster, and depths that nothing uses. */
    private fun near(polygon: ExactPolygon): List<Int> = polygon.contours.first().map { it.coerceIn(-NEAR, NEAR) }

    /** Returns a number that decides about sizes, for the shape with this [index]. */
    private fun size(index: Int, numbers: List<Int>): Int = Tint.hash(index, 2, numbers[0], numbers[1])

    /** A point around the first vertex; half of them have edges on samples if the vertex is at one, or at a corner. */
    private fun point(index: Int, polygon: ExactPolygon, alpha: Int = 255): CorpusPoint {
        val numbers = near(polygon)
        val size = size(index, numbers)
        val half = if (size % 2 == 0) 128 * (1 + size / 32 % 6) else 128 + size / 32 % 900
        return CorpusPoint(numbers[0], numbers[1], size / 2 % 16 / 16f, half, CorpusColor.of(index, alpha = alpha))
    }

    /** A line between the first two vertices. Half of them are as thin as possible, and some have no length. */
    private fun line(index: Int, polygon: ExactPolygon, alpha: Int = 255): CorpusLine {
        val numbers = near(polygon)
        val size = size(index, numbers)
        val half = if (size % 2 == 0) 128 else 128 + size / 512 % 500
        val last = if (size / 4096 % 8 == 0) 0 else 3
        val ends = listOf(numbers[0], numbers[1], numbers[last], numbers[last + 1])
        val depths = listOf(size / 2 % 16 / 16f, size / 32 % 16 / 16f)
        return CorpusLine(ends, depths, half, CorpusColor.of(index, alpha = alpha))
    }

    /** A sphere around the first vertex. Half of the radii are whole pixels. */
    private fun sphere(index: Int, polygon: ExactPolygon, alpha: Int = 255): CorpusSphere {
        val numbers = near(polygon)
        val size = size(index, numbers)
        val radius = if (size % 2 == 0) 256 * (2 + size / 8192 % 9) else 512 + size / 8192 % 2048
        val color = CorpusColor.of(index, alpha = alpha)
        return CorpusSphere(numbers[0], numbers[1], 20 * 256 + size / 2 % 2560, radius, color)
    }

    /** In grid steps: 30 pixels. */
    private const val NEAR = 30 * 256

    /** In grid steps: 2^19 pixels. */
    private const val GUARD_BAND = 1 shl 27

    /** How many of the colours are dark. */
    private const val DARK = 12

    /** Alphas of shapes that are mostly translucent. */
    private val ALPHAS = listOf(128, 64, 230, 0, 255)
}
