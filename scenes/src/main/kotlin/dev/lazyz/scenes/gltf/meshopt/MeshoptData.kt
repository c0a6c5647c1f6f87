package dev.lazyz.scenes.gltf.meshopt

import dev.lazyz.scenes.loading.Source
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * The parameters that `EXT_meshopt_compression` or `KHR_meshopt_compression` gives for a buffer view (Khronos Group,
 * "KHR_meshopt_compression", release candidate; this package refers to the appendices of that document). The two
 * extensions differ in the features that an encoder may use. All features are decoded under either name.
 *
 * @property count number of elements
 * @property stride size of an element in bytes
 * @throws MeshoptException if the extension does not allow this combination of parameters
 */
internal class MeshoptData(private val mode: String, private val filter: String, val count: Int, val stride: Int) {
    init {
        val isAttributes = mode == "ATTRIBUTES"
        check(count >= 0, "count", "$count")
        check(isAttributes || mode == "TRIANGLES" || mode == "INDICES", "mode", mode)
        val strides = if (isAttributes) 4..256 step 4 else 2..4 step 2
        check(stride in strides, "byteStride", "$stride")
        check(mode != "TRIANGLES" || count % 3 == 0, "count", "$count")
        val isFilterAllowed = when (filter) {
            "NONE" -> true
            "OCTAHEDRAL", "COLOR" -> isAttributes && (stride == 4 || stride == 8)
            "QUATERNION" -> isAttributes && stride == 8
            "EXPONENTIAL" -> isAttributes
            else -> false
        }
        check(isFilterAllowed, "filter", filter)
    }

    private fun check(isGood: Boolean, name: String, value: String) {
        if (!isGood) throw MeshoptException("$name is $value, which mode $mode does not allow")
    }

    /**
     * Returns the elements decoded from [bytes].
     *
     * @param work counts steps of work, see [Source.step]
     * @throws MeshoptException if the bytes are damaged
     */
    fun decode(bytes: ByteArray, work: (Int) -> Unit = {}): ByteBuffer {
        val elements = when (mode) {
            "ATTRIBUTES" -> AttributeStream.decode(bytes, count, stride, work)
            "TRIANGLES" -> TriangleStream.decode(bytes, count, stride, work)
            else -> IndexStream.decode(bytes, count, stride, work)
        }
        val buffer = ByteBuffer.wrap(elements).order(ByteOrder.LITTLE_ENDIAN)
        when (filter) {
            "OCTAHEDRAL" -> MeshoptFilter.octahedral(SmallNumbers(buffer, stride / 4), work)
            "QUATERNION" -> MeshoptFilter.quaternion(SmallNumbers(buffer, 2), work)
            "EXPONENTIAL" -> MeshoptFilter.exponential(buffer, work)
            "COLOR" -> MeshoptFilter.color(SmallNumbers(buffer, stride / 4), work)
        }
        return buffer
    }
}

/** Reports an error in a compressed buffer view. The caller adds the place in the file. */
internal class MeshoptException(message: String) : RuntimeException(message)

/** Reads [bytes] in order from [position] to [end] (exclusive), where the tail of the stream begins. */
internal class CompressedBytes(private val bytes: ByteArray, private var position: Int, private val end: Int) {
    init {
        if (end < position || end > bytes.size) throw MeshoptException("the ${bytes.size} compressed bytes are too few")
    }

    /** Returns the next byte, 0..255. */
    fun next(): Int {
        if (position == end) throw MeshoptException("the compressed data ends too early, at byte $position of it")
        return bytes[position++].toInt() and 0xFF
    }

    /** Returns a number of 1 to 5 bytes with 7 bits each, lowest bits first. */
    fun variable(): Int {
        var value = 0
        for (shift in 0..28 step 7) {
            val byte = next()
            value = value or (byte and 0x7F shl shift)
            if (byte < 0x80) return value
        }
        throw MeshoptException("a number before byte $position of the compressed data has more than 5 bytes")
    }

    /** Fails if bytes are left over. */
    fun expectEnd() {
        if (position != end) throw MeshoptException("${end - position} bytes of the compressed data are left over")
    }
}

/** Decodes a difference: even codes stand for 0, 1, 2 and so on, odd codes for -1, -2, -3 and so on. */
internal fun signed(code: Int): Int = (code ushr 1) xor -(code and 1)

/** Reads the differences of one byte of each element of a block, in groups of 16 (appendix A, "Mode 0: attributes"). */
internal object ByteGroups {
    private const val GROUP = 16
    private val bitsOfVersion0 = intArrayOf(0, 2, 4, 8)
    private val bitsOfControl = arrayOf(intArrayOf(0, 1, 2, 4), intArrayOf(1, 2, 4, 8))

    /**
     * Fills [into] with [count] differences, starting at index [from].
     *
     * @param control the control mode of version 1, or null in version 0
     */
    fun read(input: CompressedBytes, control: Int?, into: ByteArray, from: Int, count: Int) {
        when (control) {
            2 -> into.fill(0, from, from + count)
            3 -> for (i in from until from + count) into[i] = input.next().toByte()
            else -> groups(input, if (control == null) bitsOfVersion0 else bitsOfControl[control], into, from, count)
        }
    }

    private fun groups(input: CompressedBytes, widths: IntArray, into: ByteArray, from: Int, count: Int) {
        // Two bits for each group give the width of its numbers
        val groups = (count + GROUP - 1) / GROUP
        val header = IntArray((groups + 3) / 4) { input.next() }
        for (group in 0 until groups) {
            val bits = widths[header[group / 4] shr group % 4 * 2 and 3]
            group(input, bits, into, from + group * GROUP, from + count)
        }
    }

    /** Reads 16 numbers. Those at [end] and after it are discarded. */
    private fun group(input: CompressedBytes, bits: Int, into: ByteArray, start: Int, end: Int) {
        if (bits == 0) return into.fill(0, start, minOf(start + GROUP, end))
        val packed = IntArray(GROUP * bits / 8) { input.next() }
        val sentinel = (1 shl bits) - 1
        val perByte = 8 / bits
        for (i in 0 until GROUP) {
            // Single bits start at the lowest bit, wider numbers at the highest
            val place = i % perByte
            val shift = if (bits == 1) place else 8 - bits * (place + 1)
            val short = packed[i / perByte] shr shift and sentinel
            val value = if (bits < 8 && short == sentinel) input.next() else short
            if (start + i < end) into[start + i] = value.toByte()
        }
    }
}
