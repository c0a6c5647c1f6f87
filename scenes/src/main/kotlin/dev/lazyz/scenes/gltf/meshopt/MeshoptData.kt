package dev.lazyz.scenes.gltf.meshopt

import dev.lazyz.scenes.loading.Source
import java.nio.ByteBuffer
import java.nio.ByteOrder
import kotlin.math.abs
import kotlin.math.sqrt

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

/**
 * The filters that are applied to elements after decoding (appendix B). They work in place, in little-endian buffers.
 */
internal object MeshoptFilter {
    /** Decodes unit vectors stored as two coordinates of an octahedron. The third number stands for 1. */
    fun octahedral(numbers: SmallNumbers, work: (Int) -> Unit) {
        for (i in 0 until numbers.count step 4) {
            work(1)
            val one = numbers.signed(i + 2).toDouble()
            var x = numbers.signed(i) / one
            var y = numbers.signed(i + 1) / one
            val z = 1.0 - abs(x) - abs(y)

            // The lower half is folded outward
            val fold = minOf(z, 0.0)
            x += if (x >= 0.0) fold else -fold
            y += if (y >= 0.0) fold else -fold
            val scale = numbers.mostSigned / sqrt(x * x + y * y + z * z)
            numbers.put(i, rounded(x * scale))
            numbers.put(i + 1, rounded(y * scale))
            numbers.put(i + 2, rounded(z * scale))
        }
    }

    /**
     * Decodes unit quaternions stored without their largest component. The last two bits give the index of that
     * component.
     */
    fun quaternion(numbers: SmallNumbers, work: (Int) -> Unit) {
        val range = 1.0 / sqrt(2.0)
        for (i in 0 until numbers.count step 4) {
            work(1)
            val code = numbers.signed(i + 3)
            val one = (code or 3).toDouble()
            val x = numbers.signed(i) / one * range
            val y = numbers.signed(i + 1) / one * range
            val z = numbers.signed(i + 2) / one * range
            val w = sqrt(maxOf(0.0, 1.0 - x * x - y * y - z * z))
            val largest = code and 3
            for ((place, number) in doubleArrayOf(w, x, y, z).withIndex()) {
                numbers.put(i + (largest + place) % 4, rounded(number * numbers.mostSigned))
            }
        }
    }

    /** Decodes floats stored as a 24-bit integer and a power of two. */
    fun exponential(bytes: ByteBuffer, work: (Int) -> Unit) {
        for (at in 0 until bytes.capacity() step 4) {
            work(1)
            val code = bytes.getInt(at)
            bytes.putFloat(at, StrictMath.scalb((code shl 8 shr 8).toFloat(), code shr 24))
        }
    }

    /** Decodes colours stored as luma, two differences, and alpha with a 1 bit above it. */
    fun color(numbers: SmallNumbers, work: (Int) -> Unit) {
        for (i in 0 until numbers.count step 4) {
            work(1)
            val code = numbers.unsigned(i + 3)
            val most = (Integer.highestOneBit(code) shl 1) - 1
            val luma = numbers.unsigned(i)
            val orange = numbers.signed(i + 1)
            val green = numbers.signed(i + 2)
            val alpha = code and (most shr 1)
            val scale = numbers.mostUnsigned / most.toDouble()
            numbers.put(i, rounded((luma + orange - green) * scale))
            numbers.put(i + 1, rounded((luma + green) * scale))
            numbers.put(i + 2, rounded((luma - orange - green) * scale))
            numbers.put(i + 3, rounded((alpha shl 1 or (alpha and 1)) * scale))
        }
    }

    /** Rounds to the nearest integer, halves away from 0. */
    private fun rounded(x: Double): Int = if (x >= 0.0) (x + 0.5).toInt() else (x - 0.5).toInt()
}

/** Integers of [size] bytes, 1 or 2, in [bytes]. */
internal class SmallNumbers(private val bytes: ByteBuffer, private val size: Int) {
    val count: Int get() = bytes.capacity() / size
    val mostUnsigned: Int = (1 shl 8 * size) - 1
    val mostSigned: Int = mostUnsigned shr 1

    fun signed(i: Int): Int = if (size == 1) bytes.get(i).toInt() else bytes.getShort(2 * i).toInt()

    fun unsigned(i: Int): Int = signed(i) and mostUnsigned

    fun put(i: Int, number: Int) {
        if (size == 1) bytes.put(i, number.toByte()) else bytes.putShort(2 * i, number.toShort())
    }
}
