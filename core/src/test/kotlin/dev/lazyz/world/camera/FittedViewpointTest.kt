package dev.lazyz.world.camera

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.geometry.Box
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.joml.Vector3d
import org.joml.Vector4d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/** [FittedViewpoint]: the scene is in the middle of the image and touches the margin. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class FittedViewpointTest {
    private val random = Random(11)

    private fun between(low: Double, high: Double): Double = low + random.nextDouble() * (high - low)

    private fun <T> pick(vararg items: T): T = items[random.nextInt(items.size)]

    /** Vertices that are spread like a model: each direction has its own size, and some are equal. */
    private fun positions(count: Int): FloatArray {
        val size = List(3) { pick(0.02, 1.0, 5.0) }
        return FloatArray(3 * count) { (size[it % 3] * pick(random.nextGaussian(), 0.5)).toFloat() }
    }

    private fun origin(): Vector3d = pick(Vector3d(), Vector3d(3.0, -1.0, 2.0), Vector3d(1e5, 2e5, -3e5))

    /** A surface with the points that it consists of, for the check. */
    private fun surface(): Pair<Surface, List<Vector3d>> {
        val origin = origin()
        val count = pick(3, 4, 8, 40, 3000)
        val positions = positions(count)
        val points = List(count) { vertex ->
            Vector3d(origin).add(
                Vector3d(
                    positions[3 * vertex].toDouble(), positions[3 * vertex + 1].toDouble(),
                    positions[3 * vertex + 2].toDouble(),
                ),
            )
        }
        val surface = when (random.nextInt(5)) {
            0 -> Points(positions, origin = origin)
            1 -> Lines(positions, IntArray(count + count % 2) { it % count }, origin = origin)
            2 -> Polygon(points.chunked(3) { three -> three.map { Vertex(it.x, it.y, it.z) } })
            else -> Mesh(positions, IntArray((count + 2) / 3 * 3) { it % count }, origin = origin)
        }
        return surface to points
    }

    private fun viewpoint(kind: Fit): FittedViewpoint = Camera.fit(
        between(-360.0, 360.0), pick(90.0, -90.0, 0.0, between(-90.0, 90.0)), pick(1.0, between(0.2, 5.0)), kind,
        pick(0.0, Camera.DEFAULT_MARGIN, between(0.0, 45.0)), pick(30.0, between(5.0, Camera.MAX_FITTED_FIELD_OF_VIEW)),
    )

    /** Returns x and y in the image, -1..1 between the margins at zoom 1, and -1..1 between the planes. */
    private fun inImage(point: Vector3d, camera: Camera, aspect: Double, scale: Double): Vector3d {
        val p = Vector4d(point.x, point.y, point.z, 1.0)
        camera.projectionMatrix(aspect).transform(camera.viewMatrix().transform(p))
        return Vector3d(p.x / p.w / scale, p.y / p.w / scale, p.z / p.w)
    }

    private fun scaleOf(viewpoint: FittedViewpoint): Double = (1 - viewpoint.margin / 50) * viewpoint.zoom

    /** Asserts that the image of [points] is in the middle and touches the margin, up to [rounding]. */
    private fun assertFits(viewpoint: FittedViewpoint, scene: Scene, points: List<Vector3d>, rounding: Double) {
        val aspect = pick(1.0, 1.5, 0.1, 20.0)
        val camera = viewpoint.camera(scene, aspect)
        val image = points.map { inImage(it, camera, aspect, scaleOf(viewpoint)) }
        val text = "$viewpoint at $aspect: $scene from $camera"
        assertTrue(image.all { it.z in -1.0..1.0 }) { "not between the planes: $text" }
        val (left, right) = image.minOf { it.x } to image.maxOf { it.x }
        val (bottom, top) = image.minOf { it.y } to image.maxOf { it.y }
        assertEquals(0.0, left + right, rounding) { "not in the middle: $left..$right, $text" }
        assertEquals(0.0, bottom + top, rounding) { "not in the middle: $bottom..$top, $text" }
        val reach = maxOf(right, top)
        assertTrue(reach <= 1 + rounding) { "beyond the margin: $reach, $text" }
        if (!isNeedle(camera, points)) assertEquals(1.0, reach, rounding) { "does not touch the margin: $text" }
    }

    /** Whether the eye is as near as it may come, or the image is as small as a line seen end-on. */
    private fun isNeedle(camera: Camera, points: List<Vector3d>): Boolean {
        val projection = camera.projection
        if (projection is Projection.Orthographic) return projection.height < 1e-3 * (camera.far - camera.near)
        val nearest = points.minOf { -camera.viewMatrix().transformPosition(Vector3d(it)).z }
        return camera.near < nearest * 0.51
    }

    @Test
    fun verticesAreInTheMiddleAndTouchTheMargin() {
        var needles = 0
        repeat(400) {
            val surfaces = List(pick(1, 1, 3)) { surface() }.distinctBy { (_, points) -> points[0].x > 9e4 }
            val points = surfaces.flatMap { it.second }
            val scene = Scene(surfaces.map { it.first })
            val viewpoint = viewpoint(Fit.entries[random.nextInt(2)])
            // The coordinates of the eye are rounded, to 1e-16 of their size
            val size = scene.bounds!!.let { maxOf(it.maxX - it.minX, it.maxY - it.minY, it.maxZ - it.minZ) }
            val far = scene.bounds!!.center.length()
            assertFits(viewpoint, scene, points, 1e-9 + 1e-13 * far / size * viewpoint.fieldOfView)
            if (isNeedle(viewpoint.camera(scene, 1.0), points)) needles++
        }
        assertTrue(needles < 40) { "$needles of 400 scenes are not checked" }
    }

    @Test
    fun spheresTouchTheMarginWithTheirOutline() {
        repeat(100) {
            val sphere = Sphere(Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()), 2.0)
            for (kind in Fit.entries) {
                val viewpoint = viewpoint(kind)
                val camera = viewpoint.camera(Scene(listOf(sphere)), 1.0)
                val center = camera.viewMatrix().transformPosition(Vector3d(sphere.center))
                assertEquals(0.0, center.x, 1e-9)
                assertEquals(0.0, center.y, 1e-9)

                // The plane through the eye and the margin is at a distance of the radius from the centre
                val scale = 1 - viewpoint.margin / 50
                val distance = if (kind == Fit.ORTHOGRAPHIC) {
                    (camera.projection as Projection.Orthographic).height / 2 * viewpoint.zoom * scale
                } else {
                    val slope = Math.tan(Math.toRadians(viewpoint.fieldOfView / 2)) * scale
                    -center.z * slope / Math.sqrt(1 + slope * slope)
                }
                assertEquals(2.0, distance, 1e-9) { "$viewpoint" }
            }
        }
    }

    @Test
    fun propertiesAreChangedOneByOne() {
        val changed = Camera.fit().withAzimuth(1.0).withElevation(2.0).withZoom(3.0).withKind(Fit.ORTHOGRAPHIC)
            .withMargin(4.0).withFieldOfView(5.0)
        assertEquals(Camera.fit(1.0, 2.0, 3.0, Fit.ORTHOGRAPHIC, 4.0, 5.0).toString(), changed.toString())
        assertThrows<IllegalArgumentException> { changed.withElevation(91.0) }
    }

    @Test
    fun verticesThatAreNotFiniteDoNotCount() {
        val clean = Mesh(floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 2f, 0f), intArrayOf(0, 1, 2))
        for (bad in listOf(Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY)) {
            for (axis in 0 until 3) {
                val extra = FloatArray(3) { if (it == axis) bad else 50f }
                val spoilt = Mesh(extra + clean.positions, intArrayOf(0, 1, 2, 1, 2, 3))
                val expected = Camera.fit().camera(Scene(listOf(clean)), 1.0)
                assertEquals(expected.toString(), Camera.fit().camera(Scene(listOf(spoilt)), 1.0).toString())
            }
        }
    }

    @Test
    fun customSurfacesAreFittedByTheirBox() {
        val custom = object : Surface {
            override val bounds: Box = Box(-1.0, 0.0, 2.0, 3.0, 1.0, 4.0)

            override fun primitives(setUp: SetUp): Sequence<Primitive> = emptySequence()
        }
        val corners = List(8) { custom.bounds.corner(it) }
        repeat(50) { assertFits(viewpoint(pick(*Fit.entries.toTypedArray())), Scene(listOf(custom)), corners, 1e-9) }
    }

    @Test
    fun theCameraIsTheSameForAnyNumberOfThreads() {
        val mesh = Mesh(positions(100_000), IntArray(300_000) { it % 100_000 })
        val frames = listOf(1, 2, 7).map { threads ->
            val fresh = Mesh(mesh.positions, mesh.triangles)
            Scene(listOf(fresh)).frame(Raster(40, 30), RenderOptions(threads = threads))
        }
        val hashes = frames.map { ZBufferRenderer().render(it).pixelHash() }
        assertEquals(1, hashes.distinct().size, "$hashes")
    }
}
