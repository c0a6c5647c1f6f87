package dev.lazyz.aov

import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.aov.AovFrame.AovImages
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.io.IOException
import kotlin.math.abs
import kotlin.math.sqrt
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** AOVs of scenes for which the right numbers are known. */
class AovTest {
    private val up = Vector3d(0.0, 1.0, 0.0)
    private val raster = Raster(32, 24)

    /** A camera at (0, 0, 5) that looks along -z. The ray through a pixel is (px, py, -1). */
    private val camera = Camera.perspective(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 40.0, 2.0, 10.0)
    private val tangent = StrictMath.tan(20.0 * StrictMath.PI / 180)

    private fun px(x: Int) = ((x + 0.5) / raster.width * 2 - 1) * tangent * raster.width / raster.height

    private fun py(y: Int) = (1 - (y + 0.5) / raster.height * 2) * tangent

    private fun sampled(surfaces: List<Surface>, camera: Camera = this.camera, raster: Raster = this.raster) =
        SuperSampling.NONE.of(Scene(surfaces, viewpoint = camera).frame(raster))

    private fun render(frame: SampledFrame, vararg aovs: Aov): AovImages =
        AovFrame(frame, aovs.toSet()).render(TiledRenderer())

    private fun vector(image: AovImage, x: Int, y: Int) =
        Vector3d(image.number(x, y, 0), image.number(x, y, 1), image.number(x, y, 2))

    private fun forPixels(action: (x: Int, y: Int) -> Unit) {
        for (y in 0 until raster.height) for (x in 0 until raster.width) action(x, y)
    }

    @Test
    fun depthOfATiltedPlaneIsTheDistanceAlongTheLineOfSight() {
        // The plane z = 0.5 x, in front of the whole picture
        val corners = listOf(-8.0 to -8.0, 8.0 to -8.0, 8.0 to 8.0, -8.0 to 8.0)
        val plane = Polygon(listOf(corners.map { (x, y) -> Vertex(x * 0.75, y * 0.75, 0.375 * x) }))
        for (convention in DepthConvention.entries) {
            val aovs = render(sampled(listOf(plane), raster = raster.withConvention(convention)), Aov.DEPTH)
            val depth = aovs[Aov.DEPTH]
            assertEquals(listOf(2.0, 10.0), listOf(depth.lowest, depth.highest))
            forPixels { x, y ->
                // 5 - t = 0.5 px t. Vertices are snapped to 1/512 pixel, and depth changes by 0.07 a pixel at most
                val exact = 5 / (1 + 0.5 * px(x))
                assertEquals(exact, depth.number(x, y, 0), 2e-4) { "$x, $y" }
            }
        }
    }

    /** The depth test has the depth of the first vertex on all of it (contract rule 3.4). */
    @Test
    fun depthOfASliverSeenEdgeOnIsThatOfItsPosition() {
        val pixel = 2 * tangent / raster.height

        // Near to the left and right of the sample, a hundredth of a pixel below, and far, a little above it
        fun vertex(right: Double, above: Double, t: Double) =
            listOf((px(16) + right * pixel) * t, (py(12) + above * pixel) * t, 5 - t)
        val corners = listOf(vertex(-2.0, -0.02, 3.0), vertex(2.0, -0.02, 3.0), vertex(0.0, 0.05, 8.0))
        val sliver = Mesh(corners.flatten().map { it.toFloat() }.toFloatArray(), intArrayOf(0, 1, 2))
        val masked = Mesh(sliver.positions, sliver.triangles, Material(alphaMode = AlphaMode.MASK))
        for (surface in listOf(sliver, masked)) {
            val aovs = render(sampled(listOf(surface)), Aov.DEPTH, Aov.POSITION)
            val depth = aovs[Aov.DEPTH].number(16, 12, 0)
            assertEquals(depth, aovs[Aov.DEPTH].number(16, 12))
            assertEquals(5 - aovs[Aov.POSITION].number(16, 12, 2), depth, 1e-6)
            assertTrue(depth in 3.2..6.0) { "$depth" }
            assertEquals(aovs[Aov.DEPTH], render(sampled(listOf(surface)), Aov.DEPTH)[Aov.DEPTH])
        }
    }

    /** Where the ray through a pixel enters the unit sphere at the origin, as a multiple of (px, py, -1), or NaN. */
    private fun hit(x: Int, y: Int): Double {
        val a = px(x) * px(x) + py(y) * py(y) + 1
        return (5 - sqrt(25 - a * 24)) / a
    }

    @Test
    fun positionsAndNormalsOfASphereAreOnIt() {
        val aovs = render(sampled(listOf(Sphere(Vector3d(), 1.0))), Aov.POSITION, Aov.NORMAL)
        forPixels { x, y ->
            val t = hit(x, y)
            val position = vector(aovs[Aov.POSITION], x, y)
            val normal = vector(aovs[Aov.NORMAL], x, y)
            if (t.isNaN()) {
                assertEquals(Vector3d(), position)
                assertEquals(Vector3d(), normal)
            } else {
                val exact = Vector3d(px(x) * t, py(y) * t, 5 - t)
                assertTrue(exact.distance(position) < 2e-7) { "$x, $y: $position in place of $exact" }
                assertTrue(exact.distance(normal) < 3e-7) { "$x, $y: $normal in place of $exact" }
                assertEquals(1.0, normal.length(), 1e-7)
            }
        }
    }

    @Test
    fun textureCoordinatesOfASquareAreARamp() {
        val square = Mesh(
            floatArrayOf(-2f, -1.5f, 0f, 2f, -1.5f, 0f, 2f, 1.5f, 0f, -2f, 1.5f, 0f),
            intArrayOf(0, 1, 2, 0, 2, 3),
            // Neither the shading nor a texture needs them
            Material(shading = Shading.CONSTANT),
            uvs = floatArrayOf(0f, 1f, 1f, 1f, 1f, 0f, 0f, 0f),
        )
        val orthographic = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 3.0, 1.0, 9.0)
        val uv = render(sampled(listOf(square), orthographic), Aov.UV)[Aov.UV]
        forPixels { x, y ->
            assertEquals((x + 0.5) / raster.width, uv.number(x, y, 0), 1e-7)
            assertEquals((y + 0.5) / raster.height, uv.number(x, y, 1), 1e-7)
        }
    }

    @Test
    fun objectsArePartsOfTheSceneAndPrimitivesOfTheFrame() {
        val quad = floatArrayOf(-3f, -3f, -1f, 3f, -3f, -1f, 3f, 3f, -1f, -3f, 3f, -1f)
        val surfaces = listOf(
            Points(FloatArray(0)),
            Mesh(quad, intArrayOf(0, 1, 2, 0, 2, 3)),
            Points(FloatArray(0)),
            Sphere(Vector3d(), 0.5),
        )
        val aovs = render(sampled(surfaces), Aov.OBJECT, Aov.PRIMITIVE)
        assertEquals(listOf(3.0, 2.0), aovs.images.map { it.number(16, 12, 0) })
        assertEquals(listOf(1.0, 0.0), aovs.images.map { it.number(31, 23, 0) })
        assertEquals(listOf(1.0, 1.0), aovs.images.map { it.number(0, 0, 0) })
    }

    @Test
    fun pointsLinesAndTranslucentSurfacesHaveAnAnswer() {
        val point = Points(floatArrayOf(-0.8f, 0f, 0f), size = 4.0)
        val line = Lines(floatArrayOf(0f, -1f, 1f, 0f, 1f, 1f), intArrayOf(0, 1), width = 3.0)
        val glass = Sphere(Vector3d(1.0, 0.0, 0.0), 0.3, Material(Rgba(1f, 1f, 1f, 0.2f), alphaMode = AlphaMode.BLEND))
        val aovs = render(sampled(listOf(point, line, glass)), *Aov.entries.toTypedArray())
        fun at(x: Int, aov: Aov) = aovs[aov].number(x, 12, 0)
        val (ofPoint, ofLine, ofGlass) = listOf(-0.8 / 5, 0.0, 0.2).map { x ->
            (0 until raster.width).minBy { abs(px(it) - x) }
        }
        assertEquals(listOf(0.0, 1.0, 2.0), listOf(ofPoint, ofLine, ofGlass).map { at(it, Aov.OBJECT) })
        assertEquals(5.0, at(ofPoint, Aov.DEPTH), 1e-6)
        assertEquals(4.0, at(ofLine, Aov.DEPTH), 1e-6)
        assertEquals(-0.8, at(ofPoint, Aov.POSITION), 1e-7)
        for (x in listOf(ofPoint, ofLine)) {
            assertEquals(Vector3d(), vector(aovs[Aov.NORMAL], x, 12))
            assertEquals(0.0, at(x, Aov.UV))
        }
        assertTrue(at(ofGlass, Aov.DEPTH) < 5) { "the front of the glass" }
        assertEquals(listOf(1.0, 1.0), listOf(Aov.COVERAGE, Aov.OVERDRAW).map { at(ofGlass, it) })
        assertEquals(1.0, aovs[Aov.NORMAL].number(ofGlass, 12, 2), 0.3)
    }

    @Test
    fun customPrimitivesHaveTheAttributesThatTheySet() {
        class Band(private val isShaded: Boolean) : Primitive {
            override val rowStart = 2
            override val rowEnd = 5
            override val columnStart = 0
            override val columnEnd = 32

            override fun spans(y: Int, spans: Spans) {
                if (y in rowStart until rowEnd) spans.add(0, 32)
            }

            override fun depth(x: Int, y: Int): Int = Depth.NEAR

            override fun shade(fragment: Fragment) {
                fragment.u = fragment.x / 32f
                fragment.setColor(1f, 0f, 0f)
            }

            override fun geometry(fragment: Fragment) {
                if (isShaded) super.geometry(fragment) else fragment.u = 0.75f
            }
        }
        for ((isShaded, u) in listOf(true to 0.25, false to 0.75)) {
            val frame = SuperSampling.NONE.of(Frame(raster, listOf(Band(isShaded))))
            val aovs = render(frame, Aov.UV, Aov.SHADING_CALLS, Aov.DEPTH)
            assertEquals(u, aovs[Aov.UV].number(8, 3, 0))
            assertEquals(listOf(0.0, 1.0), listOf(1, 3).map { aovs[Aov.SHADING_CALLS].number(8, it, 0) })
            assertEquals(0.0, aovs[Aov.DEPTH].number(8, 3, 0))
        }
    }

    @Test
    fun anEmptyFrameHasTheBackgroundOfEachAov() {
        for (factor in listOf(1, 3)) {
            val frame = SuperSampling(factor).frame(Scene(emptyList()), Raster(2, 1))
            val aovs = render(frame, *Aov.entries.toTypedArray())
            assertEquals(Aov.entries, aovs.images.map { it.aov })
            for (image in aovs.images) {
                for (x in 0..1) {
                    for (c in image.aov.channels.indices) assertEquals(image.aov.background, image.number(x, 0, c))
                }
            }
        }
    }

    @Test
    fun coordinatesOfAModelAreTurnedBack() {
        val floats = floatArrayOf(1f, 2f, -3f, 0f, 0f, 0f)
        val position = AovImage(Aov.POSITION, Region(0, 0, 2, 1), floats, 0.0, 1.0)
        assertEquals(listOf(1f, 3f, 2f, 0f, 0f, 0f), position.toModel(UpAxis.Z).floats.toList())
        assertEquals(floats.toList(), position.toModel(UpAxis.Y).floats.toList())
        val uv = AovImage(Aov.UV, Region(0, 0, 3, 1), floats, 0.0, 1.0)
        assertEquals(floats.toList(), uv.toModel(UpAxis.Z).floats.toList())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun extremeSizes() {
        val narrow = sampled(listOf(Sphere(Vector3d(), 1.0)), raster = Raster(1, Raster.MAX_SIDE))
        val aovs = render(narrow, Aov.COVERAGE, Aov.DEPTH)
        assertEquals(1.0, aovs[Aov.COVERAGE].number(0, Raster.MAX_SIDE / 2, 0))
        val huge = sampled(emptyList(), raster = Raster(Raster.MAX_SIDE, Raster.MAX_SIDE))
        val refused = assertThrows(IllegalArgumentException::class.java) { AovFrame(huge, setOf(Aov.NORMAL)) }
        assertTrue("render regions" in refused.message!!) { refused.message }
        val corner = huge.within(Region(Raster.MAX_SIDE - 1, Raster.MAX_SIDE - 1, Raster.MAX_SIDE, Raster.MAX_SIDE))
        assertEquals(-1.0, render(corner, Aov.OBJECT)[Aov.OBJECT].numberAt(0, 0))

        // Without AOVs there is nothing to keep
        val rows = assertThrows(IOException::class.java) {
            AovFrame(huge, emptySet()).render(TiledRenderer()) { y, _, _, _ -> throw IOException("row $y") }
        }
        assertEquals("row 0", rows.message)
    }

    @Test
    fun wrongNumbersAreRefused() {
        val region = Region(0, 0, 2, 1)
        assertThrows(IllegalArgumentException::class.java) { AovImage(Aov.DEPTH, region, FloatArray(3), 0.0, 1.0) }
        assertThrows(IllegalArgumentException::class.java) { AovImage(Aov.DEPTH, region, IntArray(2)) }
        assertThrows(IllegalArgumentException::class.java) { AovImage(Aov.OBJECT, region, FloatArray(2), 0.0, 1.0) }
        val image = AovImage(Aov.OBJECT, region, IntArray(2))
        assertThrows(IllegalArgumentException::class.java) { image.number(2, 0, 0) }
        assertThrows(IllegalArgumentException::class.java) { image.number(0, 0, 1) }
        assertThrows(IllegalArgumentException::class.java) { image.numberAt(0, 1) }
    }
}
