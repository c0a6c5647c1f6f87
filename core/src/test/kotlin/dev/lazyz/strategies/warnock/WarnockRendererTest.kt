package dev.lazyz.strategies.warnock

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.Stacks
import dev.lazyz.strategies.Submission
import dev.lazyz.strategies.counted
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class WarnockRendererTest {
    private fun counted(frame: Frame) = WarnockRenderer().counted(frame)

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun depthsDoNotGrowWithLayersApartInDepth() {
        // One depth a sample, and one for each of the four bands, for any number of layers
        for (submission in Submission.entries) {
            for (count in listOf(5, 40)) {
                val counters = counted(Stacks.layers(Raster(256, 256), count, submission))
                assertEquals(count * 65536L, counters.fragments)
                assertEquals(65536L + 4, counters.depthEvaluations, "$count layers $submission")
            }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun depthsHardlyGrowWithLayersThatOverlapInDepth() {
        // Each layer is compared with the first once a band, by planes
        for (submission in Submission.entries) {
            for (count in listOf(5, 40)) {
                val counters = counted(Stacks.layers(Raster(256, 256), count, submission, steepness = count / 2.0))
                val comparing = counters.depthEvaluations - 65536
                assertTrue(comparing <= 4 * 3 * count, "$comparing to compare $count layers $submission")
            }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun depthsGrowWithVisibleComplexityOnly() {
        // More layers show more edges, but a hundred times as many layers show less than a hundred times as many edges
        for (submission in Submission.entries) {
            val ten = counted(Stacks.twisted(640, 480, 10, submission))
            val hundred = counted(Stacks.twisted(640, 480, 100, submission))
            val thousand = counted(Stacks.twisted(640, 480, 1000, submission))
            assertTrue(thousand.fragments > 99 * ten.fragments, "$ten\n$thousand")
            assertTrue(hundred.depthEvaluations < 2 * ten.depthEvaluations, "$ten\n$hundred")
            assertTrue(thousand.depthEvaluations < 12 * ten.depthEvaluations, "$ten\n$thousand")
        }
    }

    @Test
    fun eachRowIsAskedForOnce() {
        val raster = Raster(200, 200)
        val asked = IntArray(200)
        val layer = Stacks.layers(raster, 1, Submission.FRONT_TO_BACK).primitives[0]
        val witness = object : Primitive by layer {
            override fun cursor(y: Int): SpanCursor {
                val cursor = layer.cursor(y)
                var row = y
                return SpanCursor {
                    asked[row++]++
                    cursor.next(it)
                }
            }

            override fun spans(y: Int, spans: Spans): Unit = throw AssertionError("row $y")
        }
        WarnockRenderer().render(Frame(raster, listOf(witness), Region(0, 3, 200, 190)))
        assertEquals(List(200) { if (it in 3 until 190) 1 else 0 }, asked.toList())
    }

    @Test
    fun widePicturesHaveLowBands() {
        val frame = Stacks.layers(Raster(Raster.MAX_SIDE, 9), 2, Submission.FRONT_TO_BACK)
        val counters = WarnockRenderer().render(frame) { _, _, _, _ -> }
        assertEquals(9L * Raster.MAX_SIDE, counters.shadingCalls)
        assertTrue(counters.peakBytes < (8L shl 20) + 13L * Raster.MAX_SIDE, "${counters.peakBytes}")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun memoryIsThatOfABandAndItsSpans() {
        val counters = counted(Stacks.layers(Raster(512, 512), 100, Submission.SHUFFLED))
        val spans = 100L * 64 * 3 * Int.SIZE_BYTES
        assertTrue(counters.peakBytes > 8 * 512 * 64 + spans, "${counters.peakBytes}")
        assertTrue(counters.peakBytes < 8 * 512 * 64 + spans + 20 * 512 + 100 * 600, "${counters.peakBytes}")
    }

    @Test
    fun anAreaIsRelatedToACoverageExactly() {
        for (seed in 0L until 300L) {
            val frame = AwkwardFrames(seed).frame()
            val region = frame.region
            val random = Random(seed)
            val coverages = BandCoverages(frame, Counters.Builder())
            val bandEnd = minOf(region.rowStart + 64, region.rowEnd)
            val band = Region(region.columnStart, region.rowStart, region.columnEnd, bandEnd)
            coverages.moveTo(band)
            repeat(20) {
                val x = random.nextInt(band.columnStart, band.columnEnd)
                val y = random.nextInt(band.rowStart, band.rowEnd)
                val area = Region(x, y, random.nextInt(x, band.columnEnd) + 1, random.nextInt(y, band.rowEnd) + 1)
                for (i in 0 until coverages.count) {
                    val coverage = coverages[i]
                    assertEquals(coveredIn(area, coverage.primitive), coverage.samplesIn(area), "seed $seed, $area")
                }
            }
        }
    }

    private fun coveredIn(area: Region, primitive: Primitive): Int {
        val spans = area.spans()
        var count = 0
        for (y in area.rowStart until area.rowEnd) {
            spans.clear()
            primitive.spans(y, spans)
            for (i in 0 until spans.count) count += spans.end(i) - spans.start(i)
        }
        return count
    }
}
