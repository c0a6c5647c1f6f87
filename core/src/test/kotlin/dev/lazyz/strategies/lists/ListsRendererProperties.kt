package dev.lazyz.strategies.lists

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import kotlin.math.abs
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Compares the pictures of the selectors with plain lists made in the test. */
class ListsRendererProperties {
    @Property(tries = 300, seed = "20260202", edgeCases = EdgeCasesMode.NONE)
    fun selectorsPickFromTheSortedList(@ForAll seed: Long, @ForAll @IntRange(min = 1, max = 5) k: Int) {
        val frame = AwkwardFrames(seed, 24).frame()
        val cells = cells(frame)
        check(frame, cells, Selector.nearest()) { it.first() }
        check(frame, cells, Selector.farthest()) { it.last() }
        check(frame, cells, Selector.kthNearest(k)) { it.getOrNull(k - 1) }

        val ramp = intArrayOf(0x440154, 0x46327e, 0x365c8d, 0x277f8e) +
            IntArray(4) { 0x1fa187 } + IntArray(8) { 0x4ac16d } + IntArray(16) { 0xa0da39 }
        val counted = ListsRenderer(RenderOptions(selector = Selector.count())).render(frame)
        assertEquals(0, counted.counters.shadingCalls)
        val shown = ZBufferRenderer().render(frame)
        assertTrue(shown.depth.contentEquals(counted.depth) && shown.primitive.contentEquals(counted.primitive))
        for ((i, list) in cells.withIndex()) {
            val color = ramp.getOrElse(list.size - 1) { 0xfde725 } or (0xFF shl 24)
            assertEquals(if (list.isEmpty()) frame.raster.background.toArgb() else color, counted.argb[i])
        }
    }

    @Property(tries = 200, seed = "20260203", edgeCases = EdgeCasesMode.NONE)
    fun rule_5_5_blendingIsTheCompositeInOrderOfDepth(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = AwkwardFrames(seed, 24).translucent()
        val image = ListsRenderer(RenderOptions(coherence)).render(frame.takeIf { it.hasTranslucency } ?: return)
        val nearest = ZBufferRenderer().render(frame.asOpaque())
        assertTrue(nearest.depth.contentEquals(image.depth) && nearest.primitive.contentEquals(image.primitive))
        for ((i, list) in cells(frame).withIndex()) {
            val x = frame.region.columnStart + i % frame.width
            val y = frame.region.rowStart + i / frame.width
            assertEquals(composite(frame, list, x, y).toArgb(), image.argb[i]) { "at $x, $y of $list" }
            assertIsNear(textbook(frame, list, x, y), image.argb[i])
        }
    }

    @Property(tries = 200, seed = "20260204", edgeCases = EdgeCasesMode.NONE)
    fun rule_5_5_aRegionOfABlendedPictureIsThatPartOfTheWhole(@ForAll seed: Long) {
        val frame = AwkwardFrames(seed, 24).translucent()
        val whole = ListsRenderer().render(Frame(frame.raster, frame.primitives))
        val part =
            ListsRenderer(RenderOptions(selector = if (frame.hasTranslucency) Selector.blend() else null)).render(frame)
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            for (x in frame.region.columnStart until frame.region.columnEnd) {
                assertEquals(whole.argb(x, y), part.argb(x, y))
            }
        }
    }

    /** For each sample of the region, the indices of its fragments from near to far, computed in the simplest way. */
    private fun cells(frame: Frame): List<List<Int>> {
        val test = frame.raster.depthTest
        val background = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
        val cells = List(frame.region.size.toInt()) { ArrayList<Int>() }
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            for ((index, primitive) in frame.primitives.withIndex()) {
                val spans = frame.region.spans()
                primitive.spans(y, spans)
                for (i in 0 until spans.count) {
                    for (x in spans.start(i) until spans.end(i)) {
                        val at = (y - frame.region.rowStart) * frame.width + x - frame.region.columnStart
                        if (test.key(primitive.depth(x, y), index) < background) cells[at].add(index)
                    }
                }
            }
            for (column in 0 until frame.width) {
                val x = frame.region.columnStart + column
                cells[(y - frame.region.rowStart) * frame.width + column]
                    .sortBy { test.key(frame.primitives[it].depth(x, y), it) }
            }
        }
        return cells
    }

    private fun check(frame: Frame, cells: List<List<Int>>, selector: Selector, pick: (List<Int>) -> Int?) {
        val image: Image = ListsRenderer(RenderOptions(selector = selector)).render(frame)
        assertEquals(image.visible.toLong(), image.counters.shadingCalls)
        for ((i, list) in cells.withIndex()) {
            val index = if (list.isEmpty()) null else pick(list)
            val x = frame.region.columnStart + i % frame.width
            val y = frame.region.rowStart + i / frame.width
            assertEquals(index ?: DepthTest.BACKGROUND, image.primitive[i])
            val depth = index?.let { frame.primitives[it].depth(x, y) } ?: frame.raster.backgroundDepth
            assertEquals(depth, image.depth[i])
            val color = index?.let { shaded(frame, it, x, y) } ?: frame.raster.background
            assertEquals(color.toArgb(), image.argb[i])
        }
    }

    private fun shaded(frame: Frame, index: Int, x: Int, y: Int): Rgba {
        val fragment = Fragment()
        fragment.moveTo(x, y)
        frame.primitives[index].shade(fragment)
        return Rgba(fragment.red, fragment.green, fragment.blue, fragment.alpha)
    }

    /** The layers of rule 5.5, from near to far: the translucent ones, followed by the backdrop. */
    private fun layers(frame: Frame, list: List<Int>, x: Int, y: Int): List<Rgba> {
        val opaque = list.indexOfFirst { !frame.primitives[it].isTranslucent }
        val seen = if (opaque < 0) list else list.take(opaque + 1)
        val colors = seen.map { shaded(frame, it, x, y) }
        return if (opaque < 0) colors + frame.raster.background else colors
    }

    /** Rule 5.5, implemented literally. */
    private fun composite(frame: Frame, list: List<Int>, x: Int, y: Int): Rgba {
        val layers = layers(frame, list, x, y)
        val opacities = layers.map { if (it.alpha.isNaN()) 0f else it.alpha.coerceIn(0f, 1f) }
        if (opacities.dropLast(1).all { it == 0f }) return layers.last()
        val sums = FloatArray(4)
        var transmittance = 1f
        for ((layer, opacity) in layers.zip(opacities)) {
            val weight = transmittance * opacity
            if (weight == 0f) continue
            sums[0] += weight * layer.red
            sums[1] += weight * layer.green
            sums[2] += weight * layer.blue
            sums[3] += weight
            transmittance *= 1f - opacity
        }
        return Rgba(sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3], sums[3])
    }

    /** Back-to-front blending in double precision: each layer over what is behind it. */
    private fun textbook(frame: Frame, list: List<Int>, x: Int, y: Int): DoubleArray {
        val result = DoubleArray(4)
        for (layer in layers(frame, list, x, y).reversed()) {
            val a = if (layer.alpha.isNaN()) 0.0 else layer.alpha.toDouble().coerceIn(0.0, 1.0)
            val components = listOf(layer.red, layer.green, layer.blue)
            for (i in 0 until 3) result[i] = components[i] * a + result[i] * (1 - a)
            result[3] = a + result[3] * (1 - a)
        }
        if (result[3] > 0) for (i in 0 until 3) result[i] /= result[3]
        return result
    }

    private fun assertIsNear(expected: DoubleArray, argb: Int) {
        if (expected[3] == 0.0) return assertEquals(0, argb ushr 24)
        val (red, green, blue, alpha) = expected.map { it.toFloat() }
        val code = Rgba(red, green, blue, alpha).toArgb()
        for (shift in 0..24 step 8) assertTrue(abs((code ushr shift and 0xFF) - (argb ushr shift and 0xFF)) <= 1)
    }
}
