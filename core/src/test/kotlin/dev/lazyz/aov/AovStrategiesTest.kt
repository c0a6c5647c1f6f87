package dev.lazyz.aov

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.SampleScenes
import dev.lazyz.Selector
import dev.lazyz.ShadingRate
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** AOVs are the same bits for every renderer, number of threads and region; counts add up to the counters. */
class AovStrategiesTest {
    private val raster = Raster(24, 18)
    private val ofScene = Aov.entries.toSet() - Aov.SHADING_CALLS

    /** Many triangles in a batch, of each kind of shading, behind and in front of each other. */
    private val opaque = Scene(
        Shading.entries.map { SampleScenes.soup(Random(it.ordinal + 7L), 20, Material(shading = it)) },
        viewpoint = SampleScenes.camera,
    )
    private val mixed = SampleScenes.mixed(Random(3))

    private fun frames(): List<SampledFrame> = listOf(
        SuperSampling.NONE.frame(opaque, raster),
        SuperSampling(2).frame(opaque, raster),
        SuperSampling(3, PixelFilter.MITCHELL).frame(mixed, raster),
        SuperSampling(4, rate = ShadingRate.PIXEL).frame(opaque, raster),
        SuperSampling.NONE.of(SampleScenes.drawn(Random(5), raster, 40)),
    )

    private fun renderers(frame: SampledFrame): List<Renderer> =
        Renderers.builtIn.filter { !frame.frame.hasTranslucency || Capability.TRANSPARENCY in it.capabilities }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun allRenderersThreadsAndRegionsGiveTheSameBits() {
        for (frame in frames()) {
            val expected = AovFrame(frame, ofScene).render(
                ZBufferRenderer().takeUnless {
                    frame.frame.hasTranslucency
                } ?: ListsRenderer()
            )
            assertTrue(expected[Aov.OBJECT].ints.any { it >= 0 }) { "$frame" }
            for (renderer in renderers(frame)) {
                for (threads in listOf(1, 3)) {
                    val options = RenderOptions(threads = threads, tileSize = 8)
                    val aovs = AovFrame(frame, ofScene).render(renderer.configured(options))
                    assertEquals(expected.images, aovs.images) { "${renderer.id}, $threads threads, $frame" }
                }
                for (region in listOf(Region(5, 3, 14, 17), Region(0, 0, 1, 1), Region(23, 17, 24, 18))) {
                    val part = AovFrame(frame.within(region), ofScene).render(renderer)
                    part.images.zip(expected.images).forEach { (image, whole) -> requirePart(whole, image, region) }
                }
            }
        }
    }

    private fun requirePart(whole: AovImage, part: AovImage, region: Region) {
        assertEquals(region, part.region)
        for (y in region.rowStart until region.rowEnd) {
            for (x in region.columnStart until region.columnEnd) {
                for (channel in whole.aov.channels.indices) {
                    val expected = whole.number(x, y, channel)
                    assertEquals(expected, part.number(x, y, channel)) { "${whole.aov.id} at $x, $y" }
                }
            }
        }
    }

    @Test
    fun theyAreThoseOfThePixelsNearestSample() {
        val factor = 4
        val samples = SuperSampling(factor).frame(opaque, raster)
        val aovs = AovFrame(samples, ofScene).render(TiledRenderer())
        val single = AovFrame(SuperSampling.NONE.of(samples.frame), ofScene).render(TiledRenderer())
        val image = TiledRenderer().render(samples.frame)
        for (y in 0 until raster.height) {
            for (x in 0 until raster.width) {
                val own = (0 until factor * factor).map { Pair(x * factor + it % factor, y * factor + it / factor) }
                val (column, row) = own.minBy { (i, j) -> DepthTest.LESS.key(image.depth(i, j), image.primitive(i, j)) }
                for (expected in single.images.filter { it.aov.isOfPoint }) {
                    for (c in expected.aov.channels.indices) {
                        assertEquals(expected.number(column, row, c), aovs[expected.aov].number(x, y, c)) { "$x, $y" }
                    }
                }
                val covered = own.count { (i, j) -> image.primitive(i, j) != DepthTest.BACKGROUND }
                assertEquals(covered / 16.0, aovs[Aov.COVERAGE].number(x, y, 0))
                val fragments = own.sumOf { (i, j) -> single[Aov.OVERDRAW].number(i, j, 0) }
                assertEquals(fragments, aovs[Aov.OVERDRAW].number(x, y, 0))
            }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun thePictureAndTheCountersAreTheUsualOnes() {
        for (frame in frames()) {
            for (renderer in renderers(frame)) {
                val collector = Image.Collector(frame.pixels)
                val single = renderer.configured(RenderOptions(threads = 1))
                val aovs = AovFrame(frame, Aov.entries.toSet()).render(single, collector)
                val usual = frame.render(single)
                assertEquals(usual, collector.toImage(aovs.counters)) { "${renderer.id}, $frame" }
                // Without AOVs, 'tiled' makes no rows of samples, and has wider tiles
                fun work(all: Counters) = if (renderer is TiledRenderer && frame.factor > 1) all.primitives else all
                assertEquals(work(usual.counters), work(aovs.counters)) { "${renderer.id}, $frame" }
            }
        }
    }

    @Test
    fun theSelectedSurfaceCounts() {
        val frame = SuperSampling.NONE.frame(opaque, raster)
        fun depth(selector: Selector?) =
            AovFrame(frame, setOf(Aov.DEPTH))
                .render(ListsRenderer().configured(RenderOptions(selector = selector)))[Aov.DEPTH]
        val nearest = depth(null)
        assertEquals(nearest, depth(Selector.nearest()))
        assertTrue(depth(Selector.farthest()).floats.zip(nearest.floats.toList()).all { (far, near) -> far >= near })
        assertNotEquals(nearest, depth(Selector.farthest()))
    }

    @Test
    fun partsOfAFrameKnowTheirScene() {
        val frame = opaque.frame(raster)
        val kept = AovFrame(SuperSampling.NONE.of(frame.keeping { it >= 60 }), setOf(Aov.OBJECT, Aov.DEPTH))
        val aovs = kept.render(TiledRenderer())
        assertTrue(aovs[Aov.OBJECT].ints.all { it == -1 || it >= 3 })
        assertTrue(aovs[Aov.DEPTH].floats.all { it >= 1f })
        val screen = AovFrame(SuperSampling.NONE.of(Frame(raster, frame.primitives)), setOf(Aov.OBJECT))
        assertTrue(screen.render(TiledRenderer())[Aov.OBJECT].ints.all { it <= 0 })
    }
}
