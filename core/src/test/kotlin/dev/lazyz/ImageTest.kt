package dev.lazyz

import dev.lazyz.Image.PixelHash
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Sphere
import java.nio.ByteBuffer
import java.security.MessageDigest
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 7: equality and identity of images. */
class ImageTest {
    private val argb = intArrayOf(0x01020304, 0x7FFFFFFF, -1, 0x00FF00FF, 5, 6)

    private fun image(argb: IntArray = this.argb, depth: Int = 7, primitive: Int = 2, width: Int = 3) =
        Image(width, 6 / width, argb, IntArray(6) { depth + it }, IntArray(6) { primitive }, Counters.NONE)

    @Test
    fun rule_7_1_imagesAreEqualByColourDepthAndPrimitive() {
        assertEquals(image(), image())
        assertEquals(image().hashCode(), image().hashCode())
        assertNotEquals(image(), image(argb = argb.copyOf().also { it[5]++ }))
        assertNotEquals(image(), image(depth = 8))
        assertNotEquals(image(), image(primitive = 3))
        assertNotEquals(image(), image(width = 2))
        val other = Counters.Builder().apply { shadingCalls = 9 }.build()
        assertEquals(image(), Image(3, 2, argb, IntArray(6) { 7 + it }, IntArray(6) { 2 }, other))
    }

    @Test
    fun rule_7_2_thePixelHashIsWhatTheContractSays() {
        val bytes = ByteBuffer.allocate(24)
        for (color in argb) for (shift in listOf(24, 16, 8, 0)) bytes.put((color ushr shift and 0xFF).toByte())
        val expected = MessageDigest.getInstance("SHA-256").digest(bytes.array()).joinToString("") { "%02x".format(it) }
        assertEquals(expected, image().pixelHash())
        assertEquals(expected, image(depth = 99, primitive = 1, width = 2).pixelHash())
    }

    @Test
    fun rule_7_2_hashingByRowsIsHashingAtOnce() {
        val hash = PixelHash()
        hash.add(intArrayOf(argb[0], argb[1], argb[2], 99), 3)
        hash.add(argb.copyOfRange(3, 6), 3)
        assertEquals(image().pixelHash(), hash.digest())
        hash.add(argb, 6)
        assertEquals(image().pixelHash(), hash.digest())
    }

    @Test
    fun samplesAreReadByColumnAndRow() {
        assertEquals(0x00FF00FF, image().argb(0, 1))
        assertEquals(12, image().depth(2, 1))
        assertEquals(2, image().primitive(2, 1))
        assertEquals(6, image().visible)
        assertEquals(0, image(primitive = DepthTest.BACKGROUND).visible)
        assertThrows(IllegalArgumentException::class.java) { image().argb(3, 0) }
        assertThrows(IllegalArgumentException::class.java) { image().depth(0, -1) }
    }

    @Test
    fun anImageNeedsAllItsSamples() {
        assertThrows(IllegalArgumentException::class.java) {
            Image(2, 2, IntArray(4), IntArray(4), IntArray(3), Counters.NONE)
        }
    }

    @Test
    fun aRegionKeepsTheRastersColumnsAndRows() {
        val region = Region(10, 20, 13, 22)
        val image = Image(region, argb, IntArray(6), IntArray(6), Counters.NONE)
        assertEquals(argb[4], image.argb(11, 21))
        assertThrows(IllegalArgumentException::class.java) { image.argb(0, 0) }
        assertEquals(6L, region.size)
        assertEquals(true, region.contains(Region(11, 20, 13, 21)))
        assertEquals(false, region.contains(Region(11, 20, 14, 21)))
        assertEquals(Region(0, 20, 13, 30), region.union(Region(0, 25, 5, 30)))
        assertThrows(IllegalArgumentException::class.java) { Region(3, 0, 3, 1) }
        assertThrows(IllegalArgumentException::class.java) { Region(-1, 0, 3, 1) }
    }

    @Test
    fun rule_7_4_regionsThatAreBlurredCanBeMerged() {
        val raster = Raster(24, 18)
        val scene = scene { add(Sphere(Vector3d(), 1.0)) }
        val picture = SuperSampling(2, PixelFilter.MITCHELL).frame(scene, raster)
        val whole = picture.render(ZBufferRenderer())
        val parts = listOf(0 to 7, 7 to 11, 11 to 24)
            .map { (from, until) -> picture.within(Region(from, 0, until, 18)).render(ZBufferRenderer()) }
        val (a, b, c) = parts
        assertEquals(whole, Image.merge(Image.merge(a, b, raster), c, raster))
        assertEquals(whole, Image.merge(Image.merge(c, a, raster), b, raster))
        assertEquals(whole, Image.merge(whole, whole, raster))
        assertEquals(whole, Image.merge(whole, whole, raster.withBackground(Rgba.BLACK)))
        val error = assertThrows(IllegalArgumentException::class.java) { Image.merge(a, c, Raster(20, 18)) }
        assertTrue("is not within" in error.message!!, error.message)
    }

    @Test
    fun aCollectorTakesEachRowOnceInAnyOrder() {
        val numbers = IntArray(6) { it }
        val expected = Image(Region(2, 5, 4, 8), numbers, numbers, numbers, Counters.NONE)
        val collector = Image.Collector(expected.region)
        for (y in listOf(6, 5, 7)) {
            val row = intArrayOf(2 * (y - 5), 2 * (y - 5) + 1, 99)
            collector.row(y, row, row, row)
        }
        assertEquals(expected, collector.toImage(Counters.NONE))
        val long = IntArray(3)
        val short = IntArray(1)
        fun problem(y: Int, depth: IntArray = long) = assertThrows(IllegalArgumentException::class.java) {
            collector.row(y, long, depth, long)
        }.message
        assertEquals("row must be in 5..<8: 4", problem(4))
        assertEquals("row must be in 5..<8: 8", problem(8))
        assertEquals("row 6 was given before", problem(6))
        assertEquals("row 6 has 1 columns, and the image has 2", problem(6, short))
    }

    @Test
    fun aCollectorWithoutAllRowsHasNoImage() {
        val collector = Image.Collector(Region(2, 5, 4, 8))
        val row = IntArray(2)
        fun problem() = assertThrows(IllegalStateException::class.java) { collector.toImage(Counters.NONE) }.message
        assertEquals("row 5 is missing: there are 0 of 3 rows", problem())
        collector.row(5, row, row, row)
        collector.row(7, row, row, row)
        assertEquals("row 6 is missing: there are 2 of 3 rows", problem())
    }
}
