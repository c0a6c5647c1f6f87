package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.ShadingRate
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.spi.Srgb
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Sphere
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Contract rule 6.12: a pixel is the mean of its samples, for all renderers and regions. */
class SuperSamplingTest {
    private val scene = Scene(
        listOf(
            Sphere(Vector3d(), 1.0, Material(Rgba.ofRgb(0xD0452F))),
            Sphere(Vector3d(1.2, 0.6, 0.4), 0.5, Material(Rgba.ofRgb(0x2F7FD0))),
        ),
    )
    private val raster = Raster(40, 30, Rgba.TRANSPARENT)

    /** Passes the samples of [image] through the filter; a box also through the plain form that all filters have. */
    private fun filtered(
        image: Image,
        factor: Int,
        test: DepthTest = DepthTest.LESS,
        filter: PixelFilter = PixelFilter.BOX,
    ): Image {
        val raster = Raster(image.width, image.height).withDepthTest(test)
        val sampled = SuperSampling(factor, filter).of(Frame(raster, emptyList()))
        fun through(make: (RowSink) -> RowSink): Image {
            val collector = Image.Collector(sampled.pixels)
            val sink = make(collector)
            for (y in 0 until image.height) {
                val row = y * image.width until (y + 1) * image.width
                sink.row(y, image.argb.sliceArray(row), image.depth.sliceArray(row), image.primitive.sliceArray(row))
            }
            return collector.toImage(Counters.NONE)
        }
        val plain = through { FilterSink(sampled.sampling.taps, sampled.frame, sampled.pixels, it) }
        if (filter == PixelFilter.BOX) {
            assertEquals(plain, through { BoxSink(factor, sampled.frame, sampled.pixels, it) })
        }
        return plain
    }

    private fun image(side: Int, argb: (Int) -> Int, depth: (Int) -> Int = { it }, primitive: (Int) -> Int = { it }) =
        Image(
            side, side, IntArray(side * side, argb), IntArray(side * side, depth), IntArray(side * side, primitive),
            Counters.NONE,
        )

    @Test
    fun rule_6_12_meansAreThoseOfExactArithmetic() {
        val random = Random(1995)
        for (factor in listOf(2, 3, 4, 8, 16, SuperSampling.MAX_FACTOR)) {
            repeat(if (factor > 8) 4 else 40) { round ->
                val isOpaque = round % 2 == 0
                val samples = image(2 * factor, { random.nextInt() or (if (isOpaque) 0xFF shl 24 else 0) })
                val pixels = filtered(samples, factor)
                for (y in 0 until 2) for (x in 0 until 2) requireMean(samples, x, y, factor, pixels.argb(x, y))
            }
        }
    }

    private fun requireMean(samples: Image, x: Int, y: Int, factor: Int, actual: Int) {
        val colors = (0 until factor * factor).map { samples.argb(x * factor + it % factor, y * factor + it / factor) }
        val alphas = colors.map { it ushr 24 }
        assertEquals(Math.round(alphas.sum() / colors.size.toDouble()).toInt(), actual ushr 24)
        if (alphas.sum() == 0) return
        for (shift in listOf(16, 8, 0)) {
            val light = colors.sumOf { (it ushr 24) * Srgb.decode((it shr shift and 0xFF) / 255.0) } / alphas.sum()
            val code = actual shr shift and 0xFF
            val least = Srgb.decode((code - 0.5).coerceAtLeast(0.0) / 255.0)
            val most = Srgb.decode((code + 0.5) / 255.0)
            assertTrue(light in least - 1e-6..most + 1e-6) { "light $light is not code $code" }
        }
    }

    @Test
    fun rule_6_12_depthAndPrimitiveAreThoseOfTheSampleThatWins() {
        val depths = listOf(7, 5, 5, 9)
        for (test in DepthTest.entries) {
            val samples = image(2, { -1 }, { depths[it] }, { 10 + it })
            val pixel = filtered(samples, 2, test)
            val best = (0 until 4).minBy { test.key(depths[it], 10 + it) }
            assertEquals(listOf(depths[best], 10 + best), listOf(pixel.depth[0], pixel.primitive[0])) { "$test" }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rule_6_12_allRenderersGiveTheSamePixelsAlsoInRegions() {
        for (sampling in samplings()) {
            val frame = sampling.frame(scene, raster)
            val expected = frame.render(ZBufferRenderer())
            assertEquals(raster.region, expected.region)
            for (renderer in Renderers.builtIn) {
                assertEquals(expected, frame.render(renderer)) { "${renderer.id}, $sampling" }
                for (region in listOf(Region(7, 3, 20, 29), Region(0, 0, 1, 1), Region(39, 29, 40, 30))) {
                    requirePart(expected, frame.within(region).render(renderer), region)
                }
            }
        }
    }

    private fun samplings(): List<SuperSampling> = PixelFilter.entries.flatMap { filter ->
        listOf(1, 2, 4).flatMap { factor -> ShadingRate.entries.map { SuperSampling(factor, filter, it) } }
    }

    private fun requirePart(whole: Image, part: Image, region: Region) {
        assertEquals(region, part.region)
        for (y in region.rowStart until region.rowEnd) {
            for (x in region.columnStart until region.columnEnd) {
                assertEquals(whole.argb(x, y), part.argb(x, y)) { "$x, $y" }
                assertEquals(whole.depth(x, y), part.depth(x, y)) { "$x, $y" }
                assertEquals(whole.primitive(x, y), part.primitive(x, y)) { "$x, $y" }
            }
        }
    }

    /** A wide filter, computed plainly in double precision, also at the borders and with translucent samples. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rule_6_12_wideFiltersAreWeightedMeans() {
        val random = Random(7)
        for (filter in listOf(PixelFilter.MITCHELL, PixelFilter.BLACKMAN_HARRIS)) {
            for (factor in listOf(1, 2, 3, 4, 16, SuperSampling.MAX_FACTOR)) {
                val side = 6 * factor
                val samples = image(side, { random.nextInt() or if (factor % 2 == 0) 0xFF shl 24 else 0 })
                val pixels = filtered(samples, factor, filter = filter)
                for (y in 0 until 6) {
                    for (x in 0 until 6) requireWeighted(samples, filter, factor, x, y, pixels.argb(x, y))
                }
            }
        }
    }

    private fun requireWeighted(samples: Image, filter: PixelFilter, factor: Int, x: Int, y: Int, actual: Int) {
        val sums = DoubleArray(5)
        for (row in 0 until samples.height) {
            for (column in 0 until samples.width) {
                val weight = filter.weight((column + 0.5) / factor - x - 0.5) * inside(filter, column, factor, x) *
                    filter.weight((row + 0.5) / factor - y - 0.5) * inside(filter, row, factor, y)
                if (weight == 0.0) continue
                val color = samples.argb(column, row)
                sums[4] += weight
                sums[3] += weight * (color ushr 24)
                for (k in 0 until 3) {
                    sums[k] += weight * (color ushr 24) * Srgb.decode((color ushr 16 - 8 * k and 0xFF) / 255.0)
                }
            }
        }
        assertEquals((sums[3] / sums[4]).coerceIn(0.0, 255.0), (actual ushr 24).toDouble(), 0.6)
        if (sums[3] / sums[4] < 20) return
        for (k in 0 until 3) {
            val light = (sums[k] / sums[3]).coerceIn(0.0, 1.0)
            val code = actual ushr 16 - 8 * k and 0xFF
            assertTrue(light >= Srgb.decode((code - 0.6).coerceAtLeast(0.0) / 255.0) - 3e-4) { "$light, $code" }
            assertTrue(light <= Srgb.decode((code + 0.6) / 255.0) + 3e-4) { "$light, $code" }
        }
    }

    private fun inside(filter: PixelFilter, sample: Int, factor: Int, pixel: Int): Int =
        if (Math.abs((sample + 0.5) / factor - pixel - 0.5) <= filter.radius) 1 else 0

    @Test
    fun aPrimitiveIsShadedOnceInEachOfItsPixels() {
        val perSample = SuperSampling(4).frame(scene, raster).render(TiledRenderer())
        val frame = SuperSampling(4, rate = ShadingRate.PIXEL).frame(scene, raster)
        val image = frame.render(TiledRenderer())
        assertEquals(perSample.depth.toList(), image.depth.toList())
        assertEquals(perSample.primitive.toList(), image.primitive.toList())
        assertEquals(primitivesInPixels(frame.frame, 4), image.counters.shadingCalls)
        for (i in image.argb.indices) assertEquals(perSample.argb[i] ushr 24, image.argb[i] ushr 24)
    }

    private fun primitivesInPixels(frame: Frame, factor: Int): Long {
        val image = ZBufferRenderer().render(frame)
        val seen = HashSet<Triple<Int, Int, Int>>()
        for (y in 0 until image.height) {
            for (x in 0 until image.width) seen.add(Triple(x / factor, y / factor, image.primitive(x, y)))
        }
        return seen.count { it.third != DepthTest.BACKGROUND }.toLong()
    }

    @Test
    fun whatCannotBeDoneIsRefused() {
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(0) }
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(SuperSampling.MAX_FACTOR + 1) }
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(4).frame(scene, Raster(100_000, 1)) }
        val odd = Frame(Raster(3, 2), emptyList())
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(2).of(odd) }
        val small = SuperSampling(2).of(Frame(Raster(20, 20), emptyList()))
        for (outside in listOf(Region(0, 0, 10, 11), Region(5, 5, 11, 10), Region(20, 20, 30, 30))) {
            assertThrows(IllegalArgumentException::class.java) { small.within(outside) }
        }
        val onScreen = Scene(emptyList(), viewpoint = Camera.screen())
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(2).frame(onScreen, raster) }
        val wide = Scene(listOf(Points(FloatArray(3), 1500.0)))
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(4).frame(wide, raster) }
        for (refused in listOf(onScreen, wide)) assertNotNull(SuperSampling(4).obstacle(refused, raster))
        assertNull(SuperSampling(2).obstacle(wide, raster))
        assertArrayEquals(IntArray(1200), SuperSampling.NONE.frame(onScreen, raster).render(ZBufferRenderer()).argb)
    }
}
