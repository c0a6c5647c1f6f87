package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.Srgb
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.strategies.zbuffer.ZBuffer
import dev.lazyz.world.Camera
import dev.lazyz.world.FrameBuilder
import dev.lazyz.world.Lines
import dev.lazyz.world.Material
import dev.lazyz.world.Points
import dev.lazyz.world.Scene
import dev.lazyz.world.Sphere
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** A pixel is the mean of its samples: in linear light, weighted by alpha, for all renderers and regions. */
class SuperSamplingTest {
    private val scene = Scene(
        listOf(
            Sphere(Vector3d(), 1.0, Material(Rgba.ofRgb(0xD0452F))),
            Sphere(Vector3d(1.2, 0.6, 0.4), 0.5, Material(Rgba.ofRgb(0x2F7FD0))),
        ),
    )
    private val raster = Raster(40, 30, Rgba.TRANSPARENT)

    /** Passes the samples of [image] through the filter. */
    private fun filtered(image: Image, factor: Int, test: DepthTest = DepthTest.LESS): Image {
        val samples = SuperSampling(factor)
        val raster = Raster(image.width, image.height).withDepthTest(test)
        val collector = Image.Collector(samples.pixels(image.region))
        val sink = samples.toPixels(Frame(raster, emptyList()), collector)
        for (y in 0 until image.height) {
            val row = y * image.width until (y + 1) * image.width
            sink.row(y, image.argb.sliceArray(row), image.depth.sliceArray(row), image.primitive.sliceArray(row))
        }
        return collector.toImage(Counters.NONE)
    }

    private fun image(side: Int, argb: (Int) -> Int, depth: (Int) -> Int = { it }, primitive: (Int) -> Int = { it }) =
        Image(
            side, side, IntArray(side * side, argb), IntArray(side * side, depth), IntArray(side * side, primitive),
            Counters.NONE,
        )

    @Test
    fun meansAreThoseOfExactArithmetic() {
        val random = Random(1995)
        for (factor in listOf(2, 3, 4, 8, SuperSampling.MAX_FACTOR)) {
            repeat(40) { round ->
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
    fun equalSamplesAreTheirPixel() {
        for (color in listOf(0, 0x00FFFFFF, 0x01020304, 0x7F80FF00, -1, 0xFF000000.toInt(), 0xFF010101.toInt())) {
            for (factor in 1..SuperSampling.MAX_FACTOR) {
                val pixels = filtered(image(factor, { color }), factor)
                assertEquals(color, pixels.argb[0]) { "%08x, %d".format(color, factor) }
            }
        }
    }

    @Test
    fun blackAndWhiteGiveHalfTheLight() {
        // Half of the light has the code 188, not 128
        val pixel = filtered(image(2, { if (it % 2 == 0) -1 else 0xFF000000.toInt() }), 2).argb[0]
        assertEquals(0xFFBCBCBC.toInt(), pixel)

        // Transparent samples change the alpha, and not the colour
        val edge = filtered(image(2, { if (it % 2 == 0) 0xFF204060.toInt() else 0x00FF00FF }), 2).argb[0]
        assertEquals(0x80204060.toInt(), edge)
    }

    @Test
    fun depthAndPrimitiveAreThoseOfTheSampleThatWins() {
        val depths = listOf(7, 5, 5, 9)
        for (test in DepthTest.entries) {
            val samples = image(2, { -1 }, { depths[it] }, { 10 + it })
            val pixel = filtered(samples, 2, test)
            val best = (0 until 4).minBy { test.key(depths[it], 10 + it) }
            assertEquals(listOf(depths[best], 10 + best), listOf(pixel.depth[0], pixel.primitive[0])) { "$test" }
        }
    }

    @Test
    fun allRenderersGiveTheSamePixelsAlsoInRegions() {
        for (factor in listOf(1, 2, 4)) {
            val smooth = SuperSampling(factor)
            val frame = smooth.frame(scene, raster)
            val expected = smooth.render(ZBuffer(), frame)
            assertEquals(raster.region, expected.region)
            val region = Region(7, 3, 20, 29)
            for (renderer in Renderers.builtIn) {
                assertEquals(expected, smooth.render(renderer, frame), renderer.id)
                val part = smooth.render(renderer, frame.within(smooth.samples(region)))
                assertEquals(region, part.region)
                for (y in 3 until 29) for (x in 7 until 20) assertEquals(expected.argb(x, y), part.argb(x, y))
            }
        }
    }

    @Test
    fun oneSampleAPixelChangesNothing() {
        assertEquals(Tiled().render(scene.frame(raster)), SuperSampling.NONE.render(Tiled(), scene.frame(raster)))
    }

    @Test
    fun coverageOfASlantedEdgeIsItsArea() {
        // A right triangle covers half of every pixel on its hypotenuse, except for the samples on it
        val factor = 8
        val side = 10 * factor
        val corners = doubleArrayOf(0.0, 0.0, 0.5, side.toDouble(), side.toDouble(), 0.5, 0.0, side.toDouble(), 0.5)
        val frame = FrameBuilder(Raster(side, side, Rgba.TRANSPARENT)).polygon(Rgba.BLACK, corners).build()
        val image = SuperSampling(factor).render(ZBuffer(), frame)
        for (i in 0 until 10) assertEquals(127.5, (image.argb(i, i) ushr 24).toDouble(), 255.0 / (2 * factor) + 1)
        assertEquals(255, image.argb(2, 7) ushr 24)
        assertEquals(0, image.argb(7, 2) ushr 24)
    }

    @Test
    fun pointsAndLinesKeepTheirSizeInPixels() {
        val positions = floatArrayOf(-1f, 0f, 0f, 1f, 0f, 0f)
        val white = Material(Rgba.WHITE)
        val drawn = Scene(
            listOf(Points(positions, 6.0, white), Lines(positions, intArrayOf(0, 1), 3.0, white)),
            background = Rgba.TRANSPARENT,
        )
        val pixels = Raster(64, 32, Rgba.TRANSPARENT)
        val areas = listOf(1, 4).map { factor ->
            val smooth = SuperSampling(factor)
            smooth.render(ZBuffer(), smooth.frame(drawn, pixels)).argb.sumOf { it ushr 24 } / 255.0
        }
        assertEquals(areas[0], areas[1], 0.06 * areas[0])
    }

    @Test
    fun whatCannotBeDoneIsRefused() {
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(0) }
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(SuperSampling.MAX_FACTOR + 1) }
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(4).frame(scene, Raster(100_000, 1)) }
        assertThrows(IllegalArgumentException::class.java) { SuperSampling(2).pixels(Region(0, 0, 3, 2)) }
        val onScreen = Scene(emptyList(), viewpoint = Camera.screen())
        assertThrows(UnsupportedOperationException::class.java) { SuperSampling(2).frame(onScreen, raster) }
        val alone = SuperSampling.NONE.frame(onScreen, raster)
        assertArrayEquals(IntArray(1200), SuperSampling.NONE.render(ZBuffer(), alone).argb)
    }
}
