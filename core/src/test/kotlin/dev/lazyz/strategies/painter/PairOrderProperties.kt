package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.AwkwardFrames
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

class PairOrderProperties {
    @Property(tries = 150, seed = "1972")
    fun whatIsProvedHoldsAtEverySharedSample(@ForAll seed: Long) {
        val frame = AwkwardFrames(seed, 40).frame()
        val pairs = PairOrder(frame, Counters.Builder())
        val keys = frame.primitives.indices.map { keys(frame, it) }
        for (a in keys.indices) {
            for (b in keys.indices - a) {
                val shared = keys[a].keys intersect keys[b].keys
                val where = "AwkwardFrames($seed, 40).frame(), primitives $a and $b"
                if (pairs.isApart(a, b)) assertTrue(shared.isEmpty(), where)
                if (!pairs.isBefore(a, b)) continue
                for (sample in shared) assertTrue(keys[a][sample]!! < keys[b][sample]!!, where)
            }
        }
    }

    @Property(tries = 150, seed = "1979")
    fun anOutlineIsTheHullOfTheSamples(@ForAll seed: Long) {
        val frame = AwkwardFrames(seed, 40).frame()
        for (index in frame.primitives.indices) {
            val samples = keys(frame, index).keys
            val outline = Outline.of(frame.primitives[index], frame.region)
            val corners = (0 until outline.count).map { outline.xs[it] to outline.ys[it] }
            assertEquals(corners.distinct(), corners)
            assertTrue(samples.containsAll(corners))
            assertEquals(samples.isEmpty(), corners.isEmpty())
            for (i in corners.indices) {
                val (ax, ay) = corners[i]
                val (bx, by) = corners[(i + 1) % corners.size]
                for ((x, y) in samples) assertTrue((bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0)
            }
        }
    }

    private fun keys(frame: Frame, index: Int): Map<Pair<Int, Int>, Long> {
        val keys = HashMap<Pair<Int, Int>, Long>()
        val primitive = frame.primitives[index]
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            val spans = frame.region.spans()
            primitive.spans(y, spans)
            for (i in 0 until spans.count) {
                for (x in spans.start(i) until spans.end(i)) {
                    keys[x to y] = frame.raster.depthTest.key(primitive.depth(x, y), index)
                }
            }
        }
        return keys
    }
}
