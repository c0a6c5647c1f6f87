package dev.lazyz.strategies.lazy

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 5, 7 and 8: the same picture as the z-buffer's, with the promised amount of work. */
class LazyRendererProperties {
    @Property(tries = 200, seed = "57", edgeCases = EdgeCasesMode.NONE)
    fun anyBudgetIsKeptAndGivesTheSameRows(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = AwkwardFrames(seed, 40).frame()
        val random = Random(seed)
        val expected = ZBufferRenderer().render(frame)
        for (budget in listOf(0L, random.nextInt(1_000).toLong(), random.nextInt(8_000).toLong(), Long.MAX_VALUE)) {
            val renderer = LazyRenderer(RenderOptions(coherence, memoryBudget = budget))
            val image = renderer.render(frame)
            assertEquals(expected, image)
            assertEquals(expected.counters.primitives, image.counters.primitives)
            assertEquals(expected.counters.fragments, image.counters.fragments)
            assertEquals(expected.counters.depthEvaluations, image.counters.depthEvaluations)
            assertEquals(image.visible.toLong(), image.counters.shadingCalls)
            val empty = renderer.render(Frame(frame.raster, emptyList(), frame.region)).counters.peakBytes
            assertTrue(image.counters.peakBytes - empty <= budget) { "$budget: ${image.counters.peakBytes}, $empty" }
        }
    }

    @Property(tries = 200, seed = "56", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_rowsAreThePictureInAnyOrderOfLooking(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = AwkwardFrames(seed, 40).frame()
        val expected = ZBufferRenderer().render(frame)
        val random = Random(seed)
        var counters = Counters.NONE

        // Keep all rows, then read some columns, then all columns, from the last row to the first
        for (row in LazyRenderer(RenderOptions(coherence)).rows(frame).toList().reversed()) {
            for (x in (row.columnStart until row.columnEnd).shuffled(random).take(random.nextInt(row.width + 1))) {
                assertEquals(expected.argb(x, row.y), row.argb(x))
            }
            if (random.nextBoolean()) row.argb()
            for (x in row.columnStart until row.columnEnd) {
                assertEquals(expected.argb(x, row.y), row.argb(x))
                assertEquals(expected.argb(x, row.y), row.argb()[x - row.columnStart])
                assertEquals(expected.depth(x, row.y), row.depth(x))
                assertEquals(expected.primitive(x, row.y), row.primitive(x))
            }
            val visible = (row.columnStart until row.columnEnd).count { row.primitive(it) != DepthTest.BACKGROUND }
            assertEquals(visible.toLong(), row.counters.shadingCalls)
            assertEquals(visible.toLong(), row.counters.peakSuspensions)
            counters = counters.plus(row.counters)
        }
        assertEquals(expected.counters.fragments, counters.fragments)
        assertEquals(expected.counters.primitives, counters.primitives)
    }
}
