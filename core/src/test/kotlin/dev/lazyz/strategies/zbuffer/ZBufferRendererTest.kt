package dev.lazyz.strategies.zbuffer

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.SampleScenes
import dev.lazyz.render
import dev.lazyz.samples
import java.util.Random
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 8 for the z-buffer, and its additional promises. */
class ZBufferRendererTest {
    private fun frames(): List<Frame> {
        val random = Random(11)
        return List(15) { SampleScenes.mixed(random).frame(24, 18) } +
            List(15) { SampleScenes.drawn(random, Raster(20, 20), 12) }
    }

    @Test
    fun rule_8_1_countersMeanWhatTheyMean() {
        for (frame in frames()) {
            val image = ZBufferRenderer().render(frame)
            val counters = image.counters
            val fragments = frame.primitives.sumOf { it.samples(frame.raster).size.toLong() }
            assertEquals(frame.primitives.size.toLong(), counters.primitives)
            assertEquals(fragments, counters.fragments)
            assertEquals(fragments, counters.depthEvaluations)
            assertEquals(counters.depthPasses, counters.shadingCalls)
            assertEquals(12L * frame.width * frame.height, counters.peakBytes)
            assertEquals(0, counters.shadingSteps)
            assertEquals(0, counters.peakSuspensions)
        }
    }

    @Test
    fun aFailingFlowHandsOutNoRows() {
        val failing = flow<Primitive> { error("torn") }
        var rows = 0
        val exception = assertThrows(IllegalStateException::class.java) {
            runBlocking { ZBufferRenderer().render(Raster(4, 4), failing) { _, _, _, _ -> rows++ } }
        }
        assertEquals("torn", exception.message)
        assertEquals(0, rows)
    }

    @Test
    fun rule_7_2_aPictureOfEverythingIsTheSameOnEveryMachine() {
        // The scene has its own camera and lights; the hash changes only with the contract
        val image = ZBufferRenderer().render(SampleScenes.mixed(Random(1995)).frame(96, 72))
        assertEquals("ba4ca7ba2667a09fff57ddc49df7c4e3cf4c776075fa7b0b0d536728e7ee6078", image.pixelHash())
    }

    @Test
    fun tooManySamplesAreRefused() {
        val exception = assertThrows(IllegalArgumentException::class.java) {
            ZBufferRenderer().render(Frame(Raster(Raster.MAX_SIDE, Raster.MAX_SIDE), emptyList())) { _, _, _, _ -> }
        }
        assertTrue(exception.message!!.contains("68719476736"))
    }
}
