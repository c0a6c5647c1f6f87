package dev.lazyz.conformance

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Spans
import java.util.Collections
import java.util.EnumMap
import java.util.EnumSet
import java.util.IdentityHashMap

/** Counts the frames that a rule is tried on by their traits. Thread safe: a rule may try frames in several threads. */
internal class Census {
    private val counts = EnumMap<FrameTrait, Long>(FrameTrait::class.java)
    private val seen = Collections.newSetFromMap(IdentityHashMap<Frame, Boolean>())
    private var frames = 0L
    private var unexamined = 0L

    /** From here on a frame counts anew. */
    @Synchronized
    fun nextTry() = seen.clear()

    /** Counts [frame], unless this try had it before. */
    @Synchronized
    fun add(frame: Frame) {
        if (!seen.add(frame)) return
        frames++
        val traits = try {
            if (frame.region.size * frame.primitives.size > MOST_FRAGMENTS) null else traits(frame)
        } catch (_: Exception) {
            // Primitives may be as wild as they like; a census must not be what fails
            null
        }
        if (traits == null) unexamined++
        for (trait in traits.orEmpty()) counts.merge(trait, 1, Long::plus)
    }

    @Synchronized
    fun distribution(): Distribution = Distribution(frames, unexamined, counts.toMap())

    companion object {
        /** Larger frames are few, and would take longer to look at than to render. */
        private const val MOST_FRAGMENTS = 500_000L

        /** Returns what [frame] has. Time: samples x primitives. */
        fun traits(frame: Frame): Set<FrameTrait> {
            val traits = EnumSet.noneOf(FrameTrait::class.java)
            val raster = frame.raster
            if (frame.primitives.isEmpty()) traits.add(FrameTrait.NO_PRIMITIVES)
            if (frame.region != raster.region) traits.add(FrameTrait.REGION)
            if (frame.hasTranslucency) traits.add(FrameTrait.TRANSLUCENT)
            if (raster.width == 1 || raster.height == 1) traits.add(FrameTrait.NARROW)
            if (frame.primitives.any { it.depthForm == null }) traits.add(FrameTrait.FORMLESS)
            Samples(frame).addTo(traits)
            return traits
        }
    }

    /** The nearest two of each sample, background included. */
    private class Samples(private val frame: Frame) {
        private val test = frame.raster.depthTest
        private val background = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
        private val firstColumn = frame.region.columnStart
        private val nearest = LongArray(frame.width)
        private val second = LongArray(frame.width)
        private val spans = Spans(frame.region)
        private val visible = HashSet<Int>()
        private val pairs = HashSet<Pair<Int, Int>>()

        fun addTo(traits: MutableSet<FrameTrait>) {
            for (y in frame.region.rowStart until frame.region.rowEnd) {
                nearest.fill(background)
                second.fill(Long.MAX_VALUE)
                for (index in frame.primitives.indices) compare(index, y)
                for (i in nearest.indices) note(nearest[i], second[i], traits)
            }
            if (visible.isEmpty()) traits.add(FrameTrait.NOTHING_VISIBLE)
            if (visible.size > 1) traits.add(FrameTrait.SEVERAL_VISIBLE)
            if (pairs.any { (a, b) -> (b to a) in pairs }) traits.add(FrameTrait.CROSSING)
        }

        private fun compare(index: Int, y: Int) {
            spans.clear()
            frame.primitives[index].spans(y, spans)
            for (span in 0 until spans.count) {
                for (x in spans.start(span) until spans.end(span)) {
                    val key = test.key(frame.primitives[index].depth(x, y), index)
                    val i = x - firstColumn
                    if (key < nearest[i]) {
                        second[i] = nearest[i]
                        nearest[i] = key
                    } else if (key < second[i]) {
                        second[i] = key
                    }
                }
            }
        }

        private fun note(first: Long, next: Long, traits: MutableSet<FrameTrait>) {
            val winner = test.indexOf(first)
            if (winner != DepthTest.BACKGROUND) visible.add(winner)
            if (next == Long.MAX_VALUE) return
            val loser = test.indexOf(next)
            if (loser == DepthTest.BACKGROUND) return
            traits.add(FrameTrait.HIDDEN)
            if (winner == DepthTest.BACKGROUND) return
            if (test.depthOf(first) == test.depthOf(next)) traits.add(FrameTrait.TIE)
            pairs.add(winner to loser)
        }
    }
}
