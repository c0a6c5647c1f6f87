package dev.lazyz.conformance.frames

import dev.lazyz.Frame
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.shared.NotByDefault
import net.jqwik.api.Arbitrary
import net.jqwik.api.Example
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.junit.jupiter.api.Assertions.assertTrue

/** Frames in screen space are dense: few are empty, most primitives cover something, and samples are covered often. */
@AddLifecycleHook(NotByDefault::class)
class DenseFramesTest {
    @Example
    fun framesOfTheRulesAreDense() {
        assertDense("screen", Frames.screen(), 1.5)
        assertDense("tied", Frames.tied(), 1.5)
        assertDense("confetti", Frames.confetti(), 1.0)
    }

    @Example
    fun awkwardKindsAreWhatTheyAreNamedAfter() {
        val combs = frames(Frames.of(FrameMix.of(FrameKind.COMBS).sized(200, 40)))
        assertTrue(combs.count { most(it) { frame, y, i -> spans(frame, y, i).count } > 20 } > combs.size / 3)
        assertTrue(combs.any { most(it) { frame, y, i -> spans(frame, y, i).count } > 70 })

        val flat = frames(Frames.of(FrameMix.of(FrameKind.NEARLY_COPLANAR).counted(2, 3)))
        assertTrue(flat.count { PictureTrait.INTERPENETRATING in PictureTrait.of(it) } > flat.size / 3)

        val touching = frames(Frames.of(FrameMix.of(FrameKind.TOUCHING).counted(2, 8)))
        for (lead in -1..1) assertTrue(touching.count { touches(it, lead) } > touching.size / 5) { "$lead" }

        val confetti = frames(Frames.of(FrameMix.of(FrameKind.CONFETTI).counted(2, 8)))
        for (lead in 0..1) assertTrue(confetti.count { isLevelBehind(it, lead) } > confetti.size / 10) { "$lead" }
    }

    @Example
    fun tiesOftenLieApart() {
        val apart = frames(Frames.of(FrameMix.of(FrameKind.COINCIDENT).counted(8, 8))).count { frame ->
            val first = frame.primitives[0]
            val depth = (0 until frame.height).firstNotNullOfOrNull { depthAt(frame, 0, it) } ?: return@count false
            (2..7).any { i -> depthAt(frame, i, depth.second)?.first == depth.first && first !== frame.primitives[i] }
        }
        assertTrue(apart > 40) { "$apart" }
    }

    /** Returns the depth of a primitive at the first column that it covers in row [y], and the row. */
    private fun depthAt(frame: Frame, index: Int, y: Int): Pair<Int, Int>? {
        val spans = spans(frame, y, index)
        return if (spans.count == 0) null else frame.primitives[index].depth(spans.start(0), y) to y
    }

    /**
     * Whether a polygon of constant depth is [lead] units behind an end of a slope. Bounds of polygons have a margin of
     * one unit on each side.
     */
    private fun touches(frame: Frame, lead: Int): Boolean = frame.primitives.any { slope ->
        slope.greatestDepth - slope.leastDepth > 2 && frame.primitives.any { level ->
            level.greatestDepth - level.leastDepth == 2 &&
                (level.leastDepth == slope.leastDepth + lead || level.greatestDepth == slope.greatestDepth + lead)
        }
    }

    /** Whether a primitive with tight bounds is [lead] units behind another. */
    private fun isLevelBehind(frame: Frame, lead: Int): Boolean {
        val levels = frame.primitives.filter { it.leastDepth == it.greatestDepth }
        return levels.any { a -> levels.any { b -> a !== b && b.leastDepth == a.leastDepth + lead } }
    }

    private fun assertDense(name: String, frames: Arbitrary<FrameCase>, leastDepthComplexity: Double) {
        val some = frames(frames).filter { it.primitives.isNotEmpty() }
        val blank = some.count { ReferenceRenderer().render(it).visible == 0 }
        val covered = some.flatMap { frame -> frame.primitives.indices.map { coverage(frame, it) } }
        val idle = covered.count { it == 0 }
        val complexity = some.map { frame ->
            frame.primitives.indices.sumOf { coverage(frame, it) }.toDouble() / frame.raster.size
        }.average()
        val numbers = "$name: $blank of ${some.size} frames are blank, $idle of ${covered.size} primitives cover " +
            "nothing, depth complexity is $complexity"
        assertTrue(blank < 0.05 * some.size, numbers)
        assertTrue(idle < 0.2 * covered.size, numbers)
        assertTrue(complexity >= leastDepthComplexity, numbers)
    }

    private fun coverage(frame: Frame, index: Int): Int = (0 until frame.height).sumOf { y ->
        val spans = spans(frame, y, index)
        (0 until spans.count).sumOf { spans.end(it) - spans.start(it) }
    }

    private fun most(frame: Frame, value: (Frame, Int, Int) -> Int): Int =
        frame.primitives.indices.maxOfOrNull { i -> (0 until frame.height).maxOf { value(frame, it, i) } } ?: 0

    private fun spans(frame: Frame, y: Int, index: Int) =
        frame.region.spans().also { frame.primitives[index].spans(y, it) }

    private fun frames(cases: Arbitrary<FrameCase>): List<Frame> = some(cases, 300).map { it.frame }
}
