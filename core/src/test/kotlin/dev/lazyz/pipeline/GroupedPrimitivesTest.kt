package dev.lazyz.pipeline

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.StreamingRenderer
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Primitives that arrive one by one, for renderers that need them all at once. */
class GroupedPrimitivesTest {
    private fun streamed(renderer: StreamingRenderer, frame: Frame, primitives: List<Primitive>): Image {
        val drawing = renderer.begin(frame.raster, frame.region)
        primitives.forEach(drawing::add)
        val collector = Image.Collector(frame.region)
        return collector.toImage(drawing.finish(collector))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun manyPrimitivesGiveThePictureOfTheFrame() {
        // So many that hidden ones are dropped several times
        val frame = glazed(3).frame(40, 37)
        val count = frame.primitives.size
        val many = List(50_000) { frame.primitives[it * 7 % count] }
        val opaque = many.filter { !it.isTranslucent }
        val expected = TiledRenderer().render(Frame(frame.raster, opaque, frame.region))
        for (renderer in listOf(TiledRenderer(), HierarchicalRenderer())) {
            val image = streamed(renderer, frame, opaque)
            assertEquals(expected.pixelHash(), image.pixelHash(), "$renderer")
            for (x in 0 until 40) assertEquals(expected.primitive(x, 18), image.primitive(x, 18), "$renderer")
            assertEquals(opaque.size.toLong(), image.counters.primitives)
        }
        val mixed = List(2000) { frame.primitives[it * 7 % count] }
        val blended = TiledRenderer().render(Frame(frame.raster, mixed, frame.region))
        assertEquals(blended.pixelHash(), streamed(TiledRenderer(), frame, mixed).pixelHash())
    }

    @Test
    fun visibleFragmentsAreCountedOnce() {
        // All are visible, and are kept by each of several passes
        val raster = Raster(256, 256)
        val primitives = List(65_536) { index ->
            val (x, y) = index % 256 to index / 256
            OneSample(x, y)
        }
        for (renderer in listOf(TiledRenderer(), HierarchicalRenderer())) {
            val counters = streamed(renderer, Frame(raster, primitives), primitives).counters
            assertEquals(65_536, counters.fragments, "$renderer")
            assertEquals(65_536, counters.depthPasses, "$renderer")
        }
    }
}

private class OneSample(private val x: Int, private val y: Int) : Primitive {
    override val rowStart: Int get() = y
    override val rowEnd: Int get() = y + 1
    override val columnStart: Int get() = x
    override val columnEnd: Int get() = x + 1

    override fun spans(y: Int, spans: Spans) {
        if (y == this.y) spans.add(x, x + 1)
    }

    override fun depth(x: Int, y: Int): Int = 0

    override fun shade(fragment: Fragment) = fragment.setColor(1f, 1f, 1f)
}
