package dev.lazyz.spark.triangles

import dev.lazyz.Region
import java.io.Serializable
import java.nio.ByteBuffer

/**
 * Fragments of a band, as runs of consecutive samples: of each the samples since the last run, its length, and of its
 * fragments the differences of depth and index to the fragment before, in as few bytes as they need. Then colours, if
 * there are any. Immutable.
 */
internal class FragmentRuns private constructor(private val bytes: ByteArray, private val isShaded: Boolean) :
    Serializable {
    /** Number of bytes. */
    val size: Int get() = bytes.size

    /** Calls [action] for each fragment of a band that shows [region]. The colour is 0 if there is none. */
    fun forEach(region: Region, action: (x: Int, y: Int, key: Long, color: Int) -> Unit) {
        val input = Numbers(bytes)
        var sample = 0
        var upper = 0L
        var lower = 0L
        while (input.hasNext()) {
            sample += input.next().toInt()
            repeat(input.next().toInt()) {
                upper += input.nextSigned()
                lower += input.nextSigned()
                val color = if (isShaded) input.nextColor() else 0
                val x = region.columnStart + sample % region.width
                action(x, region.rowStart + sample / region.width, upper shl 32 or lower, color)
                sample++
            }
        }
    }

    /** Collects fragments in ascending order of their samples. Not thread safe. */
    class Builder(private val isShaded: Boolean) {
        private var bytes = ByteArray(1 shl 12)
        private var size = 0
        private var end = 0
        private var run = LongArray(RUN)
        private var colors = IntArray(RUN)
        private var length = 0
        private var start = 0
        private var upper = 0L
        private var lower = 0L

        /** Adds the fragment of sample number [sample] of the band. */
        fun add(sample: Int, key: Long, color: Int) {
            if (length > 0 && (sample != start + length || length == RUN)) flush()
            if (length == 0) start = sample
            run[length] = key
            colors[length++] = color
        }

        private fun flush() {
            put((start - end).toLong())
            put(length.toLong())
            for (i in 0 until length) {
                putSigned((run[i] ushr 32) - upper)
                putSigned((run[i] and LOWER) - lower)
                upper = run[i] ushr 32
                lower = run[i] and LOWER
                if (isShaded) putColor(colors[i])
            }
            end = start + length
            length = 0
        }

        /** Returns the fragments. */
        fun build(): FragmentRuns {
            if (length > 0) flush()
            return FragmentRuns(bytes.copyOf(size), isShaded)
        }

        private fun putSigned(number: Long) = put(number shl 1 xor (number shr 63))

        /** Seven bits a byte, from the lowest; all but the last have the sign bit. */
        private fun put(number: Long) {
            reserve()
            var rest = number
            while (rest and 0x7F.inv() != 0L) {
                bytes[size++] = (rest or 0x80).toByte()
                rest = rest ushr 7
            }
            bytes[size++] = rest.toByte()
        }

        private fun putColor(color: Int) {
            reserve()
            ByteBuffer.wrap(bytes).putInt(size, color)
            size += Int.SIZE_BYTES
        }

        private fun reserve() {
            if (size + MOST_BYTES > bytes.size) bytes = bytes.copyOf(2 * bytes.size)
        }
    }

    /** Reads what a builder writes. */
    class Numbers(private val bytes: ByteArray) {
        private var at = 0
        private val buffer = ByteBuffer.wrap(bytes)

        fun hasNext(): Boolean = at < bytes.size

        fun next(): Long {
            var number = 0L
            var shift = 0
            while (true) {
                val byte = bytes[at++].toLong()
                number = number or (byte and 0x7F shl shift)
                if (byte >= 0) return number
                shift += 7
            }
        }

        fun nextSigned(): Long = next().let { it ushr 1 xor -(it and 1) }

        fun nextColor(): Int = buffer.getInt(at).also { at += Int.SIZE_BYTES }
    }

    private companion object {
        const val LOWER = 0xFFFFFFFFL

        /** Most samples of a run. */
        const val RUN = 1 shl 10

        /** Bytes of the longest number. */
        const val MOST_BYTES = 10
    }
}
