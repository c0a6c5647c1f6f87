package dev.lazyz.conformance.oracle

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.spi.Fragment

/**
 * The expected starts and steps of shading when each row is visited once, for a given [Coherence]: those that reach
 * the fragments that show through, of each primitive in each row from left to right.
 */
internal class ExpectedSteps private constructor(private val coherence: Coherence) {
    /** Number of colours whose attributes are evaluated at the sample. */
    var starts = 0L
        private set

    /** Number of steps from one sample to the next. */
    var steps = 0L
        private set

    override fun toString(): String = "$starts starts and $steps steps"

    private fun add(shown: Shown) {
        val reach = when (coherence) {
            Coherence.DIRECT -> 0
            Coherence.INCREMENTAL -> Int.MAX_VALUE
            Coherence.ADAPTIVE -> shown.primitive.shadingStartCost
        }
        for ((y, columns) in shown.columns) {
            columns.sorted().zipWithNext { last, x ->
                if (x - last <= reach && shown.primitive.shadingCursor(last, y) != null) steps += x - last else starts++
            }
            starts++
        }
    }

    /** Where a [primitive] shows: the columns of its shading calls by row. */
    private class Shown(val primitive: Primitive) : Primitive by primitive {
        val columns = HashMap<Int, MutableList<Int>>()

        override fun shade(fragment: Fragment) {
            columns.getOrPut(fragment.y) { ArrayList() } += fragment.x
            primitive.shade(fragment)
        }
    }

    companion object {
        /** Counts for the correct picture of [frame]. */
        fun of(frame: Frame, coherence: Coherence): ExpectedSteps {
            val shown = frame.primitives.map { Shown(it) }
            ReferenceRenderer().render(Frame(frame.raster, shown, frame.region)) { _, _, _, _ -> }
            return ExpectedSteps(coherence).apply { shown.forEach { add(it) } }
        }
    }
}
