package dev.lazyz.conformance.oracle

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Compares the oracle with pictures computed by hand. */
class ReferenceRendererTest {
    @Test
    fun leastDepthIsVisibleAndTiesGoToTheFirst() {
        assertEquals(listOf(-1, 0, 0, 1, 2, -1), visible(DepthTest.LESS, 100))
    }

    @Test
    fun greatestDepthIsVisibleAndTiesGoToTheLast() {
        assertEquals(listOf(-1, 0, 1, 2, 2, 3), visible(DepthTest.GREATER_OR_EQUAL, 0))
    }

    @Test
    fun imageHoldsColourDepthAndIndexAndTheCountersCount() {
        val image = render(DepthTest.LESS, 100)
        assertEquals(listOf(100, 10, 10, 10, 20, 100), image.depth.toList())
        val black = Rgba.BLACK.toArgb()
        val red = Rgba(1f, 0f, 0f).toArgb()
        assertEquals(listOf(black, red, red, red, red, black), image.argb.toList())
        assertEquals(4L, image.counters.primitives)
        assertEquals(7L, image.counters.fragments)
        assertEquals(4L, image.counters.depthPasses)
        assertEquals(4L, image.counters.shadingCalls)
    }

    private fun visible(test: DepthTest, backgroundDepth: Int): List<Int> =
        render(test, backgroundDepth).primitive.toList()

    private fun render(test: DepthTest, backgroundDepth: Int): Image {
        val usual = Raster(6, 1, Rgba.BLACK)
        val raster = Raster(6, 1, Rgba.BLACK, usual.convention, test, backgroundDepth)
        val primitives = listOf(Bar(1, 3, 10), Bar(2, 4, 10), Bar(3, 5, 20), Bar(5, 6, 100))
        return ReferenceRenderer().render(Frame(raster, primitives))
    }

    /** Red columns [columnStart] until [columnEnd] at one depth. */
    private class Bar(override val columnStart: Int, override val columnEnd: Int, private val depth: Int) : Primitive {
        override val rowStart: Int get() = 0
        override val rowEnd: Int get() = 1

        override fun spans(y: Int, spans: Spans) = spans.add(columnStart, columnEnd)

        override fun depth(x: Int, y: Int): Int = depth

        override fun shade(fragment: Fragment) = fragment.setColor(1f, 0f, 0f)
    }
}
