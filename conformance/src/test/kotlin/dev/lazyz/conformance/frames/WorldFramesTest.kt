package dev.lazyz.conformance.frames

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.conformance.mutants.coversAnything
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.shared.NotByDefault
import dev.lazyz.spi.Spans
import net.jqwik.api.Example
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.junit.jupiter.api.Assertions.assertTrue

/** Scenes are useful for tests: few are empty, and most of their surfaces are visible, in more than one colour. */
@AddLifecycleHook(NotByDefault::class)
class WorldFramesTest {
    @Example
    fun scenesAreWorthTheEffort() {
        for ((name, cases) in listOf("world" to WorldCases(), "long" to LongRowCases(), "blended" to BlendedCases())) {
            val worth = Worth(some(cases.get(), 150).map { it.frame.asOpaque() })
            assertTrue(worth.blank < 0.07) { "$name: $worth" }
            assertTrue(worth.nothing < 0.22) { "$name: $worth" }
            assertTrue(worth.layers >= 1.5) { "$name: $worth" }
            assertTrue(worth.colorful > 0.6) { "$name: $worth" }
        }
    }

    /** Statistics of the pictures of [frames]. */
    private class Worth(frames: List<Frame>) {
        private var primitives = 0
        private var empty = 0
        private var visible = 0
        private var severalColors = 0
        private var blanks = 0
        private var fragments = 0L
        private var covered = 0L

        init {
            for (frame in frames) add(frame)
        }

        /** Fraction of the frames that show no primitive. */
        val blank: Double = blanks.toDouble() / frames.size

        /** Fraction of the primitives that cover no sample. */
        val nothing: Double get() = empty.toDouble() / primitives

        /** Number of fragments per covered sample. */
        val layers: Double get() = fragments.toDouble() / covered

        /** Fraction of the primitives visible at two or more samples that show two or more colours. */
        val colorful: Double get() = severalColors.toDouble() / visible

        private fun add(frame: Frame) {
            val image = ReferenceRenderer().render(frame)
            if (image.visible == 0) blanks++
            val colors = image.argb.indices.filter { image.primitive[it] != DepthTest.BACKGROUND }
                .groupBy({ image.primitive[it] }, { image.argb[it] })
            visible += colors.values.count { it.size > 1 }
            severalColors += colors.values.count { it.toSet().size > 1 }
            primitives += frame.primitives.size
            for (y in 0 until frame.height) count(frame, y)
            empty += frame.primitives.count { !it.coversAnything() }
        }

        private fun count(frame: Frame, y: Int) {
            val isCovered = BooleanArray(frame.width)
            for (primitive in frame.primitives) {
                val spans = Spans().also { primitive.spans(y, it) }
                for (i in 0 until spans.count) {
                    fragments += spans.end(i) - spans.start(i)
                    isCovered.fill(true, spans.start(i), spans.end(i))
                }
            }
            covered += isCovered.count { it }
        }

        override fun toString(): String = "%.3f of the frames are blank, %.3f of the primitives cover nothing, "
            .format(blank, nothing) + "%.2f fragments a sample, %.3f of the visible have colours; %d primitives"
            .format(layers, colorful, primitives)
    }
}
