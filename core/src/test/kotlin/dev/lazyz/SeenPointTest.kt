package dev.lazyz

import dev.lazyz.Frame.SeenPoint
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame
import dev.lazyz.aov.AovFrame.AovImages
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Pieces
import dev.lazyz.world.surface.StreamedMesh
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What is seen at a sample is what the whole picture shows there. */
class SeenPointTest {
    private val random = Random(47)
    private val raster = Raster(24, 18)
    private val opaque = Scene(
        List(4) { SampleScenes.soup(random, 20, Material(), 2.0) },
        viewpoint = SampleScenes.camera,
    )

    private fun able(frame: Frame): List<Renderer> =
        Renderers.builtIn.filter { !frame.hasTranslucency || Capability.TRANSPARENCY in it.capabilities }

    private fun assertShown(image: Image, x: Int, y: Int, point: SeenPoint?, what: String) {
        assertEquals(image.primitive(x, y), point?.primitive ?: DepthTest.BACKGROUND, what)
        if (point != null) assertEquals(image.depth(x, y), point.depth, what)
    }

    /** With all depth tests, conventions, depths of the background and regions; and all kinds of primitives. */
    @Test
    fun rule_5_1_itIsWhatAllRenderersShow() {
        var visible = 0
        for (seed in 0L until 60L) {
            val awkward = AwkwardFrames(seed, 40)
            val frame = if (seed % 3 == 0L) awkward.translucent() else awkward.frame()
            val images = able(frame).associateWith { it.render(frame) }
            repeat(10) {
                val x = frame.region.columnStart + random.nextInt(frame.width)
                val y = frame.region.rowStart + random.nextInt(frame.height)
                val point = frame.at(x, y)
                if (point != null) visible++
                for ((renderer, image) in images) {
                    assertShown(image, x, y, point, "$awkward, $renderer, $x, $y")
                    assertShown(image, x, y, frame.at(x, y, renderer), "$awkward, by $renderer, $x, $y")
                }
            }
        }
        assertTrue(visible > 100) { "$visible" }
    }

    @Test
    fun rule_7_6_aSelectorsFragmentIsShown() {
        val frame = SampleScenes.drawn(random, raster, 30)
        for (selector in listOf(Selector.farthest(), Selector.kthNearest(2))) {
            val lists = ListsRenderer(RenderOptions(selector = selector))
            val image = lists.render(frame)
            for (y in 0 until 18) for (x in 0 until 24) assertShown(image, x, y, frame.at(x, y, lists), "$selector")
        }
    }

    private val aovs = setOf(Aov.OBJECT, Aov.PRIMITIVE, Aov.DEPTH, Aov.POSITION, Aov.UV)

    private fun assertSameAsAovs(expected: AovImages, x: Int, y: Int, point: SeenPoint?) {
        assertEquals(expected[Aov.OBJECT].name(x, y), point?.part)
        if (point == null) return
        assertEquals(expected[Aov.OBJECT].number(x, y).toInt(), point.surface)
        assertEquals(expected[Aov.PRIMITIVE].number(x, y).toInt(), point.primitive)
        assertEquals(expected[Aov.DEPTH].number(x, y), point.distance.toFloat().toDouble())
        val place = listOf(point.x, point.y, point.z).map { it.toFloat().toDouble() }
        assertEquals(List(3) { expected[Aov.POSITION].number(x, y, it) }, place)
        assertEquals(List(2) { expected[Aov.UV].number(x, y, it).toFloat() }, listOf(point.u, point.v))
    }

    /** Meshes, masks, spheres and slivers; frames of a scene and of the screen; pixels of several samples. */
    @Test
    fun itHasTheNumbersOfAovs() {
        val named = Scene(
            opaque.surfaces.mapIndexed { i, surface -> if (i == 2) surface else surface.withName("car/$i") },
            viewpoint = SampleScenes.camera,
        )
        val frames: List<SampledFrame> = listOf(
            SuperSampling.NONE.frame(named, raster),
            SuperSampling(4, rate = ShadingRate.PIXEL).frame(named, raster),
            SuperSampling(3, PixelFilter.MITCHELL).frame(SampleScenes.mixed(random).withoutGlass(), raster)
                .within(Region(3, 2, 20, 15)),
            SuperSampling(2).of(SampleScenes.drawn(random, raster.withSize(48, 36), 40)),
        )
        for (frame in frames) {
            val expected = AovFrame(frame, aovs).render(TiledRenderer())
            for (y in frame.pixels.rowStart until frame.pixels.rowEnd) {
                for (x in frame.pixels.columnStart until frame.pixels.columnEnd) {
                    assertSameAsAovs(expected, x, y, frame.at(x, y))
                }
            }
        }
        assertThrows(IllegalArgumentException::class.java) { frames[2].at(2, 2) }
    }

    private fun Scene.withoutGlass() = withMaterials { it.withAlphaMode(Material.AlphaMode.MASK) }

    @Test
    fun aTriangleHasItsNumberInTheMesh() {
        val frame = opaque.frame(raster)
        val points = (0 until 18).flatMap { y -> (0 until 24).mapNotNull { x -> frame.at(x, y) } }
        assertTrue(points.map { it.surface }.toSet().size > 2)
        for (point in points) assertEquals(point.primitive, 20 * point.surface + point.triangle)
    }

    @Test
    fun aStreamedModelIsReadAgain() {
        val mesh = SampleScenes.soup(random, 100, Material(), 2.0).let { Mesh(it.positions, it.triangles) }
        val pieces = Pieces(mesh, 7)
        val whole = Scene(listOf(mesh, mesh), viewpoint = SampleScenes.camera).frame(raster)
        val frame = Scene(List(2) { StreamedMesh(pieces) }, viewpoint = SampleScenes.camera).frame(raster)
        assertTrue(frame.isStreamed)
        for (x in 0 until 24) {
            assertEquals("${whole.at(x, 9)}", "${frame.at(x, 9)}")
            assertEquals("${whole.at(x, 9)}", "${frame.at(x, 9, TiledRenderer())}")
        }
    }

    @Test
    fun samplesOutsideOfTheRegionAreRefused() {
        val part = opaque.frame(raster).within(Region(5, 5, 10, 10))
        for ((x, y) in listOf(4 to 5, 10 to 5, 5 to 4, 5 to 10)) {
            val refused = assertThrows(IllegalArgumentException::class.java) { part.at(x, y) }
            assertEquals("sample must be within ${part.region}: ($x, $y)", refused.message)
            assertThrows(IllegalArgumentException::class.java) { part.at(x, y, TiledRenderer()) }
        }
        assertNull(Frame(raster, emptyList()).at(23, 17))
    }

    @Test
    fun anInterruptEndsIt() {
        Thread.currentThread().interrupt()
        assertThrows(InterruptedException::class.java) { opaque.frame(raster).at(3, 3) }
        assertFalse(Thread.interrupted())
    }
}
