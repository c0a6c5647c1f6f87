package dev.lazyz.conformance.cases

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.conformance.oracle.BlendedSample
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans

/**
 * A frame of many spans or fragments, and its picture, which is known without looking at each primitive at each sample:
 * all rows are equal. Immutable and thread safe.
 *
 * @param combs the primitives, in the order of submission, at different depths
 * @param code the call of `SuiteFrames` that returns the frame
 */
internal class Multitude private constructor(width: Int, height: Int, private val combs: List<Comb>, code: String) {
    val case: FrameCase = FrameCase(Frame(Raster(width, height), combs), "SuiteFrames.$code")

    /** The right picture. */
    val image: Image by lazy {
        val row = List(width) { x -> combs.indices.filter { combs[it].covers(x) }.sortedBy { combs[it].depth } }
        val colors = IntArray(width) { x -> color(row[x]) }
        val nearest = IntArray(width) { x -> row[x].firstOrNull() ?: DepthTest.BACKGROUND }
        val depths = IntArray(width) { x -> row[x].firstOrNull()?.let { combs[it].depth } ?: raster.backgroundDepth }
        fun rows(one: IntArray) = IntArray(width * height) { one[it % width] }
        Image(width, height, rows(colors), rows(depths), rows(nearest), Counters.NONE)
    }

    private val raster: Raster get() = case.frame.raster

    private fun color(nearestFirst: List<Int>): Int {
        val layers = nearestFirst.map { combs[it] }
        return BlendedSample.of(
            layers.map { comb -> BlendedSample.Layer(comb.isTranslucent) { comb.color } }, raster.background,
        ).toArgb()
    }

    /** Covers every [step]th column from [first] until [columnEnd] at one [depth]. */
    private class Comb(
        override val columnEnd: Int,
        override val rowEnd: Int,
        private val first: Int,
        private val step: Int,
        val depth: Int,
        val color: Rgba,
        override val isTranslucent: Boolean,
    ) : Primitive {
        override val rowStart: Int get() = 0
        override val columnStart: Int get() = first
        override val leastDepth: Int get() = depth
        override val greatestDepth: Int get() = depth

        fun covers(x: Int): Boolean = x in first..<columnEnd && (x - first) % step == 0

        override fun spans(y: Int, spans: Spans) {
            if (y !in 0..<rowEnd) return
            if (step == 1) return spans.add(first, columnEnd)
            for (x in first until columnEnd step step) spans.add(x, x + 1)
        }

        override fun depth(x: Int, y: Int): Int = depth

        override fun shade(fragment: Fragment): Unit = with(color) { fragment.setColor(red, green, blue, alpha) }
    }

    companion object {
        private const val WIDE = 33_001
        private const val SIDE = 150
        private const val LAYERS = 70
        private const val ROW = 2048
        private const val ROW_LAYERS = 700
        private const val SHARE = 37
        private const val SORTED = 40_000
        private const val DISTANCE = 1 shl 16
        private const val NEAR = 1 shl 14

        /**
         * A primitive of more than 2^14 spans in a row, before one that covers all of it. One is enough: a correct
         * renderer may query a primitive at each sample, which is slow.
         */
        fun ofSpans(): Multitude {
            val comb = Comb(WIDE, 1, 1, 2, DISTANCE, Rgba(0.8f, 0.2f, 0.5f), isTranslucent = false)
            val back = Comb(WIDE, 1, 0, 1, 2 * DISTANCE, Rgba(0.2f, 0.6f, 0.5f), isTranslucent = false)
            return Multitude(WIDE, 1, listOf(comb, back), "manySpans()")
        }

        /** More than a million fragments in one row, of primitives that begin and end at different columns. */
        fun ofRow(): Multitude {
            val combs = List(ROW_LAYERS) { i ->
                val layer = i * SHARE % ROW_LAYERS
                val color = Rgba(layer / ROW_LAYERS.toFloat(), 0.5f, 0.5f)
                val end = ROW - layer / 2
                Comb(end, 1, layer, 1, (ROW_LAYERS - layer) * DISTANCE, color, isTranslucent = false)
            }
            return Multitude(ROW, 1, combs, "longRow()")
        }

        /**
         * Many fragments at each of two samples, submitted in the order of their depths, or in the reverse order
         * [fromFar]. That is the worst order for some ways of sorting.
         */
        fun ofSorted(fromFar: Boolean, isTranslucent: Boolean): Multitude {
            val combs = List(SORTED) { i ->
                val layer = if (fromFar) SORTED - i else i
                val part = layer / SORTED.toFloat()
                Comb(2, 1, 0, 1, (layer + 1) * NEAR, Rgba(part, 1f - part, 0.5f, 1f / SORTED), isTranslucent)
            }
            return Multitude(2, 1, combs, "sorted($fromFar, $isTranslucent)")
        }

        /** More than a million fragments of thin layers, whose order of submission is not that of depth. */
        fun ofFragments(): Multitude {
            val combs = List(LAYERS) { i ->
                val layer = i * SHARE % LAYERS
                val part = layer / LAYERS.toFloat()
                val color = Rgba(part, 1f - part, 0.5f, 1f / LAYERS)
                Comb(SIDE, SIDE, 0, 1, (layer + 1) * DISTANCE, color, isTranslucent = true)
            }
            return Multitude(SIDE, SIDE, combs, "thinLayers()")
        }
    }
}
