package dev.lazyz.conformance.oracle

import dev.lazyz.Coherence
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image

/**
 * The expected starts and steps of shading when each row is visited once, for a given [Coherence]. Counted from the
 * picture and the primitives alone.
 */
internal class ExpectedSteps private constructor(private val coherence: Coherence) {
    /** Number of colours whose attributes are evaluated at the sample. */
    var starts = 0L
        private set

    /** Number of steps from one sample to the next. */
    var steps = 0L
        private set

    override fun toString(): String = "$starts starts and $steps steps"

    private fun addRow(frame: Frame, image: Image, y: Int) {
        val lastOf = HashMap<Int, Int>()
        for (x in frame.region.columnStart until frame.region.columnEnd) {
            val index = image.primitive(x, y)
            if (index == DepthTest.BACKGROUND) continue
            val primitive = frame.primitives[index]
            val last = lastOf.put(index, x)
            val reach = when (coherence) {
                Coherence.DIRECT -> 0
                Coherence.INCREMENTAL -> Int.MAX_VALUE
                Coherence.ADAPTIVE -> primitive.shadingStartCost
            }
            if (last != null && x - last <= reach && primitive.shadingCursor(last, y) != null) {
                steps += x - last
            } else {
                starts++
            }
        }
    }

    companion object {
        /** Counts for [image], the correct picture of [frame]. All primitives must be opaque. */
        fun of(frame: Frame, image: Image, coherence: Coherence): ExpectedSteps {
            val expected = ExpectedSteps(coherence)
            for (y in frame.region.rowStart until frame.region.rowEnd) expected.addRow(frame, image, y)
            return expected
        }
    }
}
