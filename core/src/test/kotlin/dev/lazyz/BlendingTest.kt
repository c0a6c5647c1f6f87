package dev.lazyz

import dev.lazyz.pipeline.Pane
import dev.lazyz.spi.Fragment
import dev.lazyz.strategies.Renderers
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 5.5: blending continues until the transmittance is 0, however small it is before. */
class BlendingTest {
    private val blending = Blending()
    private val half = fragment(0f, 0f, 0f, 0.5f)

    private fun fragment(red: Float, green: Float, blue: Float, alpha: Float): Fragment =
        Fragment().also { it.setColor(red, green, blue, alpha) }

    /** The colour of a sample behind [layers] black layers of alpha 1/2. */
    private fun behind(layers: Int, backdrop: Fragment): List<Float> {
        blending.clear()
        repeat(layers) { blending.add(half) }
        blending.end(backdrop)
        return listOf(blending.red, blending.green, blending.blue, blending.alpha)
    }

    @Test
    fun rule_5_5_openUntilNothingIsLetThrough() {
        // 2^-149 is the smallest float above 0
        blending.clear()
        assertTrue(blending.isOpen)
        for (layer in 1..149) {
            blending.add(half)
            assertTrue(blending.isOpen) { "$layer layers" }
        }
        blending.add(half)
        assertFalse(blending.isOpen)
        blending.clear()
        assertTrue(blending.isOpen)
        blending.add(fragment(0f, 0f, 0f, Math.nextDown(1f)))
        assertTrue(blending.isOpen)
        blending.add(fragment(0f, 0f, 0f, 1f))
        assertFalse(blending.isOpen)
    }

    @Test
    fun rule_5_5_theBackdropCountsHoweverLittleIsLeft() {
        for (layers in 1..126) {
            // As much brighter as the layers make it darker; the weights add up to 1
            val light = StrictMath.scalb(1f, layers)
            val color = behind(layers, fragment(light, light / 2, light / 4, 1f))
            assertEquals(listOf(1f, 0.5f, 0.25f, 1f), color) { "$layers layers" }
        }
        val closed = behind(150, fragment(Float.MAX_VALUE, 1f, 1f, 1f))
        assertEquals(listOf(0f, 0f, 0f), closed.take(3))
    }

    @Test
    fun rule_5_5_opacitiesAreClamped() {
        for (none in listOf(0f, -0f, -1f, Float.NaN, Float.NEGATIVE_INFINITY)) {
            blending.clear()
            blending.add(fragment(1f, 1f, 1f, none))
            blending.end(fragment(0.25f, 0.5f, 0.75f, none))
            // Nothing in front: the backdrop is unchanged, and its alpha is not clamped
            assertEquals(listOf(0.25f, 0.5f, 0.75f), listOf(blending.red, blending.green, blending.blue))
            assertEquals(none, blending.alpha)
            assertEquals(listOf(0f, 0f, 0f, 0.5f), behind(1, fragment(8f, 8f, 8f, none)))
        }
        for (all in listOf(1f, Math.nextUp(1f), 9f, Float.POSITIVE_INFINITY)) {
            blending.clear()
            blending.add(fragment(0.25f, 0.5f, 0.75f, all))
            assertFalse(blending.isOpen)
            blending.end(fragment(9f, 9f, 9f, 1f))
            assertEquals(
                listOf(0.25f, 0.5f, 0.75f, 1f),
                listOf(blending.red, blending.green, blending.blue, blending.alpha),
            )
            assertEquals(listOf(1f, 2f, 3f, 1f), behind(1, fragment(2f, 4f, 6f, all)))
        }
    }

    @Test
    fun rule_5_5_whatHasNoOpacityIsPassedOverWhateverItsColour() {
        val bright = fragment(Float.POSITIVE_INFINITY, Float.NaN, Float.NEGATIVE_INFINITY, 0f)
        blending.clear()
        blending.add(fragment(0.25f, 0.5f, 0.75f, 0.5f))
        blending.add(bright)
        blending.end(bright)
        val color = listOf(blending.red, blending.green, blending.blue, blending.alpha)
        assertEquals(listOf(0.25f, 0.5f, 0.75f, 0.5f), color)
    }

    @Test
    fun rule_5_5_renderersShowABrightBackdropThroughManyPanes() {
        for (layers in listOf(1, 19, 20, 21, 40, 126)) {
            val light = StrictMath.scalb(1f, layers)
            val bright = Rgba(light, light / 4, 0f)
            val expected = Rgba(1f, 0.25f, 0f).toArgb()
            val raster = Raster(3, 2)
            val panes = List(layers) { Pane(raster.region, 1000 + it, Rgba(0f, 0f, 0f, 0.5f)) }
            val walled = Frame(raster, panes + Pane(raster.region, 1 shl 30, bright))
            assertSeen(expected, walled)
            assertSeen(expected, Frame(Raster(3, 2, bright), panes))
        }
    }

    @Test
    fun rule_5_5_whatIsBehindAClosedPaneIsNotShaded() {
        for (renderer in Renderers.builtIn.filter { Capability.TRANSPARENCY in it.capabilities }) {
            val raster = Raster(3, 2)
            val panes = List(200) { Pane(raster.region, 1000 + it, Rgba(0f, 0f, 0f, 0.5f)) }
            val wall = Pane(raster.region, 1 shl 30, Rgba.WHITE)
            renderer.render(Frame(raster, panes + wall))
            val calls = (panes + wall).map { it.shadingCalls }
            assertEquals(List(150) { 6 } + List(51) { 0 }, calls, renderer.id)
        }
    }

    private fun assertSeen(argb: Int, frame: Frame) {
        for (renderer in Renderers.builtIn.filter { Capability.TRANSPARENCY in it.capabilities }) {
            val image = renderer.render(frame)
            assertTrue(image.argb.all { it == argb }) { "${renderer.id}: ${frame.primitives.size} primitives" }
        }
    }
}
