package dev.lazyz.cli.trace

import dev.lazyz.Frame
import dev.lazyz.cli.output.Mistake
import dev.lazyz.spi.ShadingObserver
import java.util.BitSet

/**
 * The shading calls of a rendering in their order, and which of them were for nothing. Memory: 8 bytes a call.
 *
 * A call is *discarded* if its colour is no part of the final pixel: an opaque fragment is before it, or the same
 * fragment is shaded once more later. [Recorder] makes the list.
 *
 * @property strategy the id of the strategy
 */
internal class ShadingOrder private constructor(
    val strategy: String,
    private val places: IntArray,
    private val kept: BitSet,
    val size: Int,
) {
    /** Number of calls that were discarded. */
    val discarded: Int = size - kept.cardinality()

    /** Returns the pixel of a call: its row times the width, plus its column, both from 0 in the region. */
    fun place(call: Int): Int = places[call]

    /** Whether the colour of a call is not part of the picture. */
    fun isDiscarded(call: Int): Boolean = !kept[call]

    /**
     * Records the shading calls of one rendering of [frame] at a time, whose samples are pixels.
     *
     * @param most the greatest number of calls
     */
    class Recorder(private val frame: Frame, private val strategy: String, private val most: Int = MOST) :
        ShadingObserver {
        private var places = IntArray(FIRST)
        private var primitives = IntArray(FIRST)
        private var size = 0

        /** Thread safe, for strategies that shade on several threads although they should not. */
        @Synchronized
        override fun shading(x: Int, y: Int, primitive: Int) {
            if (size == most) {
                throw Mistake(
                    "strategy '$strategy' makes more than %,d shading calls, too many to keep; ".format(null, most) +
                        "choose a smaller --size or a --region",
                )
            }
            if (size == places.size) {
                val room = minOf(2L * size, most.toLong()).toInt()
                places = places.copyOf(room)
                primitives = primitives.copyOf(room)
            }
            places[size] = (y - frame.region.rowStart) * frame.width + x - frame.region.columnStart
            primitives[size] = primitive
            size++
        }

        /** Returns the calls so far. */
        fun toOrder(): ShadingOrder {
            // The nearest opaque fragment of each pixel hides what is behind it, and counts only once
            val nearest = LongArray(Math.toIntExact(frame.region.size)) { Long.MAX_VALUE }
            val last = IntArray(nearest.size)
            for (call in 0 until size) {
                if (frame.primitives[primitives[call]].isTranslucent) continue
                val key = key(call)
                val place = places[call]
                if (key <= nearest[place]) {
                    nearest[place] = key
                    last[place] = call
                }
            }
            val kept = BitSet(size)
            for (call in 0 until size) {
                val key = key(call)
                val place = places[call]
                if (key < nearest[place] || (key == nearest[place] && last[place] == call)) kept.set(call)
            }
            return ShadingOrder(strategy, places, kept, size)
        }

        private fun key(call: Int): Long {
            val x = frame.region.columnStart + places[call] % frame.width
            val y = frame.region.rowStart + places[call] / frame.width
            val primitive = primitives[call]
            return frame.raster.depthTest.key(frame.primitives[primitive].depth(x, y), primitive)
        }
    }

    companion object {
        /** The greatest number of calls: 128 MiB. */
        const val MOST = 1 shl 24
        private const val FIRST = 1 shl 12
    }
}
