package dev.lazyz.setup

import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.FillRule
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class FrameBuilderTest {
    private val raster = Raster(4, 4)
    private val square = doubleArrayOf(0.0, 0.0, 0.25, 4.0, 0.0, 0.25, 4.0, 4.0, 0.25, 0.0, 4.0, 0.25)

    @Test
    fun aShaderSeesTheScreen() {
        val shader = Shader { it.setColor(it.worldX / 4, it.worldY / 4, it.worldZ) }
        val image = ZBufferRenderer().render(FrameBuilder(raster).polygon(shader, FillRule.EVEN_ODD, square).build())
        assertEquals(Rgba(2.5f / 4, 0.5f / 4, 0.25f).toArgb(), image.argb(2, 0))
        assertEquals(Depth.ofUnit(0.25), image.depth(2, 0))
    }

    @Test
    fun wrongContoursAreRefused() {
        val builder = FrameBuilder(raster)
        val pairs = assertThrows(IllegalArgumentException::class.java) { builder.polygon(Rgba.BLACK, DoubleArray(8)) }
        assertTrue(pairs.message!!.contains("8 numbers"))
        assertThrows(IllegalArgumentException::class.java) {
            builder.polygon(Rgba.BLACK, doubleArrayOf(0.0, 0.0, 0.0, 524289.0, 0.0, 0.0, 0.0, 4.0, 0.0))
        }
        assertEquals(0, builder.build().primitives.size)
    }

    @Test
    fun rastersAndOptionsAreChecked() {
        fun refused(block: () -> Unit) = assertThrows(IllegalArgumentException::class.java, block)
        refused { Raster(0, 1) }
        refused { Raster(1, Raster.MAX_SIDE + 1) }
        refused { Raster(1, 1, backgroundDepth = -1) }
        refused { RenderOptions(threads = 0) }
        refused { RenderOptions(tileSize = 48) }
        refused { RenderOptions(memoryBudget = -1) }
        refused { Frame(raster, emptyList(), Region(0, 0, 5, 4)) }
        assertEquals(1L shl 36, Raster(Raster.MAX_SIDE, Raster.MAX_SIDE).size)
    }

    @Test
    fun boxesAreChecked() {
        fun refused(block: () -> Unit) = assertThrows(IllegalArgumentException::class.java, block)
        refused { Box(1.0, 0.0, 0.0, 0.0, 1.0, 1.0) }
        refused { Box(Double.NaN, 0.0, 0.0, 1.0, 1.0, 1.0) }
        refused { Box(0.0, 0.0, 0.0, Double.POSITIVE_INFINITY, 1.0, 1.0) }
        refused { Box(0.0, 0.0, 0.0, 1.0, 1.0, 1.0).corner(8) }
        val box = Box(0.0, 1.0, 2.0, 3.0, 4.0, 5.0)
        assertEquals(Vector3d(3.0, 1.0, 5.0), box.corner(5))
        assertEquals(Vector3d(1.5, 2.5, 3.5), box.center)
        val union = box.union(Box(-1.0, 2.0, 3.0, 1.0, 3.0, 9.0))
        assertEquals(Box(-1.0, 1.0, 2.0, 3.0, 4.0, 9.0).toString(), union.toString())
    }

    @Test
    fun rule_2_3_spansKeepTheirRegion() {
        val spans = Spans(4, 10)
        spans.add(0, 3)
        spans.add(2, 5)
        spans.add(5, 6)
        spans.add(6, 6)
        spans.add(8, 20)
        spans.add(30, 40)
        assertEquals("[4..<6, 8..<10]", spans.toString())
        spans.clear()
        for (i in 0 until 3) spans.add(4 + 2 * i, 5 + 2 * i)
        assertEquals(3, spans.count)
    }

    @Test
    fun rule_2_3_spansAreAddedFromLeftToRight() {
        val spans = Spans()
        spans.add(4, 9)
        val expected = "spans must be added from left to right, without overlap: 1..<3 comes after 4..<9"
        assertEquals(expected, assertThrows(IllegalArgumentException::class.java) { spans.add(1, 3) }.message)
        assertThrows(IllegalArgumentException::class.java) { spans.add(8, 12) }
        spans.add(3, 1)
        assertEquals("[4..<9]", spans.toString())
    }
}
