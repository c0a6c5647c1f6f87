package dev.lazyz.strategies.lists

import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.pipeline.Pane
import dev.lazyz.spi.Fragment
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

/** Checks the promises of lists with their counters, and blending with examples. */
class ListsRendererTest {
    private val raster = Raster(8, 6)
    private val red = Rgba(1f, 0f, 0f, 0.5f)
    private val green = Rgba(0f, 1f, 0f, 0.25f)
    private val blue = Rgba(0f, 0f, 1f, 0.75f)
    private val grey = Rgba(0.5f, 0.5f, 0.5f)

    @Test
    fun rule_5_5_layersBlendOverTheBackdropInLinearLight() {
        val image = ListsRenderer().render(frame(layer(1, red), layer(2, green), layer(3, grey), layer(4, blue)))
        // 1/2 red, 1/8 green, and the remaining 3/8 grey
        assertEquals(Rgba(0.5f + 0.1875f, 0.125f + 0.1875f, 0.1875f).toArgb(), image.argb(3, 3))
        assertEquals(0, image.primitive(3, 3))
        assertEquals(depth(1), image.depth(3, 3))
    }

    @Test
    fun rule_5_5_overNothingTheColourHasTheLayersOwnAlpha() {
        val clear = Raster(8, 6, Rgba.TRANSPARENT)
        assertEquals(red.toArgb(), ListsRenderer().render(Frame(clear, listOf(layer(1, red)))).argb(0, 0))
        val two = ListsRenderer().render(Frame(clear, listOf(layer(1, red), layer(2, green)))).argb(0, 0)
        assertEquals(Rgba(0.8f, 0.2f, 0f, 0.625f).toArgb(), two)
    }

    @Test
    fun aTranslucentPrimitiveEndsTheListWhereItsAlphaIsOne() {
        val hidden = layer(4, grey)
        val cover = object : Primitive by layer(1, red) {
            override fun shade(fragment: Fragment) = fragment.setColor(0f, 1f, 1f, 1f)
        }
        val image = ListsRenderer().render(frame(hidden, cover))
        assertEquals(0, hidden.shadingCalls)
        assertEquals(Rgba(0f, 1f, 1f).toArgb(), image.argb(1, 1))
    }

    @Test
    fun selectorsSwapWithoutTouchingTheScanConversion() {
        val frame = frame(layer(1, grey), layer(2, grey), layer(3, grey))
        val selectors = listOf(
            Selector.nearest(), Selector.farthest(), Selector.kthNearest(2), Selector.count(), Selector.blend(),
        )
        assertEquals("[nearest, farthest, kthNearest(2), count, blend]", selectors.toString())
        for (selector in selectors) {
            val counters = ListsRenderer(RenderOptions(selector = selector)).render(frame).counters
            assertEquals(3 * raster.size, counters.fragments)
            assertEquals(3 * raster.size, counters.depthEvaluations)
            assertEquals(3L * raster.width, counters.peakSuspensions)
            assertEquals(if (selector == Selector.count()) 0 else raster.size, counters.shadingCalls)
        }
    }

    @Test
    fun aSelectorOfOnesOwnSeesTheCellAndDecides() {
        val frame = Frame(
            Raster(8, 6, Rgba.BLACK),
            listOf(layer(3, grey), layer(1, red), Pane(Region(0, 0, 4, 6), depth(2), blue)),
            Region(2, 1, 8, 5),
        )
        val selector = Selector { cell ->
            assertTrue(cell.x in 2 until 8 && cell.y in 1 until 5)
            assertEquals(Rgba.BLACK, cell.background)
            assertEquals(listOf(1, 2, 0).filter { it != 2 || cell.x < 4 }, List(cell.size) { cell.primitive(it) })
            assertEquals(depth(1), cell.depth(0))
            assertTrue(cell.isTranslucent(0) && !cell.isTranslucent(cell.size - 1))
            assertThrows<IllegalArgumentException> { cell.depth(cell.size) }
            // The middle fragment unchanged; without one, a different fragment or none
            if (cell.size == 3) {
                cell.show(1)
            } else if (cell.y == 1) {
                cell.show(1, 1f, 1f, 0f, 1f)
            }
        }
        val image = ListsRenderer(RenderOptions(selector = selector)).render(frame)
        assertEquals(blue.toArgb(), image.argb(3, 3))
        assertEquals(2, image.primitive(3, 3))
        assertEquals(Rgba(1f, 1f, 0f).toArgb(), image.argb(6, 1))
        assertEquals(0, image.primitive(6, 1))
        assertEquals(Rgba.BLACK.toArgb(), image.argb(6, 2))
        assertEquals(-1, image.primitive(6, 2))
        assertEquals(8, image.counters.shadingCalls)
    }

    @Test
    fun kMustBePositive() {
        assertThrows<IllegalArgumentException> { Selector.kthNearest(0) }
        assertEquals(Selector.kthNearest(3), Selector.kthNearest(3))
    }

    @Test
    fun primitivesLeaveAfterTheirLastRow() {
        // One primitive a row: at most one is active at a time, so only the list of arrivals grows
        val tall = Raster(4, 3000)
        val frame = Frame(tall, List(3000) { Pane(Region(0, it, 4, it + 1), depth(1), grey) })
        val few = ListsRenderer().render(Frame(tall, frame.primitives.take(10))).counters.peakBytes
        assertEquals(few + 8 * 2990, ListsRenderer().render(frame).counters.peakBytes)
    }

    @Test
    fun longRowsAreTakenInPieces() {
        val wide = Raster(3000, 1)
        val panes = List(1000) { Pane(Region(it, 0, 3000, 1), depth(1000 - it % 7), Rgba(it / 1000f, 0f, 0f)) }
        val frame = Frame(wide, panes)
        val image = ListsRenderer().render(frame)
        assertEquals(ZBufferRenderer().render(frame), image)
        assertTrue(image.counters.fragments > 2 * RowFragments.AT_ONCE)
        assertTrue(image.counters.peakSuspensions <= RowFragments.AT_ONCE)
        assertTrue(image.counters.peakBytes < 8L * RowFragments.AT_ONCE + 200_000) { image.counters.toString() }
    }

    private fun depth(level: Int): Int = Depth.NEAR + level * 1000

    private fun layer(level: Int, color: Rgba) = Pane(raster.region, depth(level), color)

    private fun frame(vararg primitives: Primitive) = Frame(raster, primitives.toList())
}
