package dev.lazyz.pipeline

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.StreamingRenderer
import dev.lazyz.strategies.hierarchical.HierarchicalZBuffer
import dev.lazyz.strategies.tiled.Tiled
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Primitives that arrive one by one, for renderers that need them all at once. */
class GroupedPrimitivesTest {
    private fun streamed(renderer: StreamingRenderer, frame: Frame, primitives: List<Primitive>): Image {
        val drawing = renderer.begin(frame.raster, frame.region)
        primitives.forEach(drawing::add)
        val collector = Image.Collector(frame.region)
        return collector.toImage(drawing.finish(collector))
    }

    @Test
    fun manyPrimitivesGiveThePictureOfTheFrame() {
        // So many that hidden ones are dropped several times
        val frame = glazed(3).frame(40, 37)
        val count = frame.primitives.size
        val many = List(50_000) { frame.primitives[it * 7 % count] }
        val opaque = many.filter { !it.isTranslucent }
        val expected = Tiled().render(Frame(frame.raster, opaque, frame.region))
        for (renderer in listOf(Tiled(), HierarchicalZBuffer())) {
            val image = streamed(renderer, frame, opaque)
            assertEquals(expected.pixelHash(), image.pixelHash(), "$renderer")
            for (x in 0 until 40) assertEquals(expected.primitive(x, 18), image.primitive(x, 18), "$renderer")
            assertEquals(opaque.size.toLong(), image.counters.primitives)
        }
        val mixed = List(2000) { frame.primitives[it * 7 % count] }
        val blended = Tiled().render(Frame(frame.raster, mixed, frame.region))
        assertEquals(blended.pixelHash(), streamed(Tiled(), frame, mixed).pixelHash())
    }
}
