package dev.lazyz.scenes.gltf.meshopt

import java.nio.ByteBuffer
import kotlin.math.abs
import kotlin.math.sqrt

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
