package dev.lazyz.conformance.oracle

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.CodeReader
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.conformance.frames.FrameKind
import dev.lazyz.conformance.frames.FrameMix
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.probes.exact
import dev.lazyz.geometry.FillRule
import dev.lazyz.shared.NotByDefault
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import net.jqwik.api.Example
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Scenes seen through a camera, from vertices to pixels, compared with exact arithmetic. */
class ExactPictureTest {
    private val random = Random(1995)
    private val up = Vector3d(0.0, 1.0, 0.0)

    /** Quarters of a unit fall on samples and corners of 8 x 8 pixels. */
    private val straight = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 4.0, 0.5, 10.0)

    @Example
    @AddLifecycleHook(NotByDefault::class)
    fun picturesOfRandomScenesAreExact() {
        var judged = 0
        repeat(150) { number ->
            val isAligned = number % 3 == 0
            val raster = if (isAligned) Raster(8, 8) else Frames.rasters().generator(1000).next(random).value()
            val camera = if (isAligned) straight else camera()
            val surfaces = List(1 + random.nextInt(5)) { surface() }
            val frame = Scene(surfaces.map { it.surface }, viewpoint = camera).frame(raster)
            val exact = surfaces.map { it.exact(raster, camera) }
            if (exact.any { it.isEmpty() }) return@repeat
            judged++
            val chosen = frame.primitives.indices.map { i -> explanation(frame, i, exact[i]) }
            for (renderer in listOf(ReferenceRenderer(), Renderers.builtIn[number % Renderers.builtIn.size])) {
                assertNull(ExactPicture(frame, chosen).fault(renderer.render(frame))) {
                    "${renderer.id} on $raster, $camera, $surfaces"
                }
            }
        }
        assertTrue(judged > 75) { "$judged scenes were judged" }
    }

    @Example
    @AddLifecycleHook(NotByDefault::class)
    fun picturesOfRandomFramesOnTheScreenAreExact() {
        val kinds = FrameKind.entries.filter { !it.isInSpace && it != FrameKind.CONFETTI }.toTypedArray()
        val cases = Frames.of(FrameMix.of(*kinds)).generator(1000)
        repeat(300) { number ->
            val case = cases.next(random).value()
            val surfaces = CodeReader(case.code).also { it.frame() }.pieces.map { piece ->
                val all = piece.contours.flatMap { it.toList() }
                if (all.size < 9 || all.any { !it.isFinite() }) null else piece.exact(case.frame.raster)
            }
            val exact = ExactPicture(case.frame, surfaces)
            for (renderer in listOf(ReferenceRenderer(), Renderers.builtIn[number % Renderers.builtIn.size])) {
                assertNull(exact.fault(renderer.render(case.frame))) { "${renderer.id} on $case" }
            }
        }
    }

    /**
     * Returns the first permitted surface that agrees with the primitive at all samples, or the first of all if none
     * does.
     */
    private fun explanation(frame: Frame, index: Int, permitted: List<ExactSurface?>): ExactSurface? =
        permitted.firstOrNull { surface -> covered(frame, index) { x, y -> surface?.coverage(x, y) } } ?: permitted[0]

    private fun covered(frame: Frame, index: Int, coverage: (Int, Int) -> Coverage?): Boolean {
        for (y in 0 until frame.height) {
            val spans = Spans().also { frame.primitives[index].spans(y, it) }
            for (x in 0 until frame.width) {
                val isCovered = (0 until spans.count).any { x in spans.start(it) until spans.end(it) }
                when (coverage(x, y)) {
                    Coverage.OPEN -> continue
                    Coverage.COVERED -> if (!isCovered) return false
                    else -> if (isCovered) return false
                }
            }
        }
        return true
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun fewSamplesOfSpheresAreLeftOpen() {
        var open = 0
        var covered = 0
        repeat(100) {
            val raster = Raster(20, 20)
            val sphere = ExactSphere(raster, camera(), sphere())
            for (i in 0 until 400) {
                when (sphere.coverage(i % 20, i / 20)) {
                    Coverage.OPEN -> open++
                    Coverage.COVERED -> covered++
                    Coverage.UNCOVERED -> Unit
                }
            }
        }
        assertTrue(covered > 4000 && open < covered / 100) { "$covered samples are covered, $open open" }
    }

    @Test
    fun sphereIsAsWorkedOutByHand() {
        // 4 x 4 samples at -1.5, -0.5, 0.5, 1.5; radius 1 before an eye at z = 5: only the middle four are hit
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 4.0, 1.0, 9.0)
        val sphere = ExactSphere(Raster(4, 4), camera, Sphere(Vector3d(), 1.0))
        val picture = (0 until 16).map { sphere.coverage(it % 4, it / 4) }
        assertEquals(listOf(5, 6, 9, 10), picture.indices.filter { picture[it] == Coverage.COVERED })

        // Distance 5 - sqrt(1/2), of 1..9
        val unit = (4.0 - Math.sqrt(0.5)) / 8.0
        val depth = (1 shl 24) + unit * (Int.MAX_VALUE - 2.0 * (1 shl 24))
        assertTrue(sphere.depthError(1, 1, Math.rint(depth).toInt()) <= 0.51)
        assertTrue(sphere.depthError(1, 1, Math.rint(depth).toInt() + 3) > 2.0)
    }

    @Test
    fun sphereThatTouchesARayIsOpen() {
        // The sample at (0.5, 0.5) is on the silhouette
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 4.0, 1.0, 9.0)
        val sphere = ExactSphere(Raster(4, 4), camera, Sphere(Vector3d(0.5, 0.0, 0.0), 0.5))
        assertEquals(Coverage.OPEN, sphere.coverage(2, 1))
        assertEquals(Coverage.UNCOVERED, sphere.coverage(3, 1))
    }

    @Test
    fun projectionCutsAtTheNearPlane() {
        // Without perspective, the near plane is at z = 4: the triangle from z = 3 to z = 5 loses the nearer half
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 4.0, 1.0, 9.0)
        val triangle = listOf(Vector3d(-1.0, -1.0, 3.0), Vector3d(1.0, -1.0, 3.0), Vector3d(0.0, 1.0, 5.0))
        val polygon = ExactProjection(Raster(4, 4), camera).polygons(listOf(triangle), FillRule.NON_ZERO).single()
        val near = 1 shl 24
        val bottom = Math.rint(near + (Int.MAX_VALUE - 2.0 * near) / 8.0).toInt()
        assertEquals(
            "ExactPolygon([[384, 512, $near, 256, 768, $bottom, 768, 768, $bottom, 640, 512, $near]], NON_ZERO)",
            polygon.toString(),
        )
    }

    @Test
    fun wrongPicturesAreFound() {
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 4.0, 1.0, 9.0)
        val raster = Raster(4, 4)
        val frame = Scene(listOf(Sphere(Vector3d(), 1.0)), viewpoint = camera).frame(raster)
        val picture = ExactPicture(frame, listOf(ExactSphere(raster, camera, Sphere(Vector3d(), 1.0))))
        val right = ReferenceRenderer().render(frame)
        assertNull(picture.fault(right))
        for (part in listOf<(Image) -> IntArray>({ it.argb }, { it.depth }, { it.primitive })) {
            val wrong = ReferenceRenderer().render(frame).also { part(it)[5] += 1 }
            assertNotNull(picture.fault(wrong))
        }
        val larger = ExactSphere(raster, camera, Sphere(Vector3d(), 1.75))
        assertEquals("sample (1, 0): primitive 0 must cover it, but does not", shown(frame, larger, right))
        val nearer = ExactSphere(raster, camera, Sphere(Vector3d(0.0, 0.0, 0.001), 1.0))
        assertTrue("units off" in shown(frame, nearer, right))
    }

    private fun shown(frame: Frame, surface: ExactSurface, image: Image): String =
        ExactPicture(frame, listOf(surface)).fault(image).orEmpty()

    /** A surface, and its exact contours. */
    private inner class Tried(val surface: Surface, private val contours: List<List<Vector3dc>>?) {
        fun exact(raster: Raster, camera: Camera): List<ExactSurface?> {
            val projection = ExactProjection(raster, camera)
            return when (surface) {
                is Sphere -> listOf(ExactSphere(raster, camera, surface))
                is Points -> projection.points(contours!![0][0], surface.size)
                is Lines -> projection.lines(contours!![0][0], contours[0][1], surface.width)
                else -> projection.polygons(contours!!, FillRule.EVEN_ODD)
            }
        }

        override fun toString(): String = "$surface $contours"
    }

    private fun camera(): Camera {
        val eye = Vector3d(random.nextGaussian(), random.nextGaussian(), 1.0 + 5.0 * random.nextDouble())
        return if (random.nextBoolean()) {
            Camera.perspective(eye, Vector3d(), up, 20.0 + 60.0 * random.nextDouble(), 0.5, 10.0)
        } else {
            Camera.orthographic(eye, Vector3d(), up, 4.0, 0.5, 10.0)
        }
    }

    private fun sphere() = Sphere(point(1.5), oneOf(0.3, 1.0, 3.0))

    private fun oneOf(vararg values: Double) = values[random.nextInt(values.size)]

    private fun point(size: Double): Vector3d {
        if (random.nextBoolean()) return Vector3d(quarters(), quarters(), quarters())
        return Vector3d(random.nextGaussian() * size, random.nextGaussian() * size, random.nextGaussian() * size)
    }

    private fun quarters() = (random.nextInt(17) - 8) / 4.0

    private fun surface(): Tried = when (random.nextInt(6)) {
        0 -> Tried(sphere(), null)
        4 -> point()
        5 -> line()
        1 -> List(3) { point(1.5) }.let { Tried(Polygon(listOf(it.map { p -> Vertex(p.x, p.y, p.z) })), listOf(it)) }
        2 -> mesh()
        else -> holed()
    }

    private fun point(): Tried {
        val (numbers, positions) = floats(1)
        return Tried(Points(numbers, oneOf(0.5, 1.0, 2.0, 3.3, 9.0)), listOf(positions))
    }

    private fun line(): Tried {
        val (numbers, positions) = floats(2)
        return Tried(Lines(numbers, intArrayOf(0, 1), oneOf(0.5, 1.0, 2.0, 3.3, 9.0)), listOf(positions))
    }

    /** Generates points, both as floats and as vectors of the same values. */
    private fun floats(count: Int): Pair<FloatArray, List<Vector3d>> {
        val numbers = List(count) { point(1.5) }.flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }
        return Pair(
            numbers.toFloatArray(),
            numbers.map {
                it.toDouble()
            }.chunked(3).map { (x, y, z) -> Vector3d(x, y, z) }
        )
    }

    private fun mesh(): Tried {
        val positions = FloatArray(9) { point(2.0).x.toFloat() }
        val corners = (0 until 3).map { i ->
            Vector3d(positions[3 * i].toDouble(), positions[3 * i + 1].toDouble(), positions[3 * i + 2].toDouble())
        }
        return Tried(Mesh(positions, intArrayOf(0, 1, 2)), listOf(corners))
    }

    private fun holed(): Tried {
        val z = random.nextGaussian()
        val outer = listOf(-1.0 to -1.0, 1.0 to -1.0, 1.0 to 1.0, -1.0 to 1.0)
        val inner = List(3) { random.nextDouble() - 0.5 to random.nextDouble() - 0.5 }
        val contours = listOf(outer, inner).map { contour -> contour.map { (x, y) -> Vector3d(x, y, z + x / 4.0) } }
        val vertices = contours.map { contour -> contour.map { Vertex(it.x, it.y, it.z) } }
        return Tried(Polygon(vertices), contours)
    }
}
