package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.strategies.lazy.LazyRenderer
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class LazyRowTest {
    private val raster = Raster(100, 4, Rgba.BLACK)
    private val tile = Witness(Region(20, 0, 80, 4), Depth.NEAR)
    private val row = LazyRenderer().rows(Frame(raster, listOf(tile)).within(Region(10, 1, 90, 3))).first()

    @Test
    fun columnsAreTheRastersWithinTheRegion() {
        assertEquals(listOf(1, 10, 90, 80), listOf(row.y, row.columnStart, row.columnEnd, row.width))
        assertEquals(DepthTest.BACKGROUND, row.primitive(19))
        assertEquals(0, row.primitive(20))
        assertEquals(Int.MAX_VALUE, row.depth(89))
        assertEquals(Depth.NEAR, row.depth(79))
        assertEquals(80, row.argb().size)
        val message = assertThrows(IllegalArgumentException::class.java) { row.argb(90) }.message
        assertEquals("column must be in 10..<90: 90", message)
        assertThrows(IllegalArgumentException::class.java) { row.depth(9) }
        assertThrows(IllegalArgumentException::class.java) { row.primitive(0) }
    }

    @Test
    fun theBackgroundHasAColourWithoutAShadingCall() {
        assertEquals(Rgba.BLACK.toArgb(), row.argb(10))
        assertEquals(0, row.counters.shadingCalls)
    }

    @Test
    fun aSinkGetsTheRowAndNothingIsShadedTwice() {
        row.argb(30)
        repeat(2) {
            row.sendTo { y, argb, depth, primitive ->
                assertEquals(1, y)
                assertEquals(List(80) { row.argb(10 + it) }, argb.toList())
                assertEquals(List(80) { row.depth(10 + it) }, depth.toList())
                assertEquals(List(80) { row.primitive(10 + it) }, primitive.toList())
            }
        }
        assertEquals(60, tile.shaded.size)
    }

    @Test
    fun threadsThatLookAtOnceShadeOnce() {
        val threads = Executors.newFixedThreadPool(4)
        try {
            val looks = List(8) { i ->
                Callable { if (i % 2 == 0) List(80) { row.argb(10 + it) } else row.argb().toList() }
            }
            assertEquals(1, threads.invokeAll(looks).map { it.get() }.distinct().size)
        } finally {
            threads.shutdown()
        }
        assertEquals(60, tile.shaded.size)
        assertTrue("LazyRow(1, columns 10..<90, Counters(primitives=1" in row.toString())
    }
}
