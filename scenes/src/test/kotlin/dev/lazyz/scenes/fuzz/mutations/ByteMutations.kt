package dev.lazyz.scenes.fuzz.mutations

import java.util.Random

/** Changes bytes, whatever they mean. */
internal object ByteMutations : Mutations {
    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray {
        val at = random.nextInt(input.size + 1)
        val length = random.small(input.size - at + 1)
        return when (random.nextInt(9)) {
            0 -> changed(input, random) { (it.toInt() xor (1 shl random.nextInt(8))).toByte() }
            1 -> changed(input, random) { random.nextInt().toByte() }
            2 -> changed(input, random) { random.pick(ODD).toByte() }
            3 -> replaced(input, at, length, ByteArray(0))
            4 -> replaced(input, at, 0, ByteArray(1 + random.small(64)) { random.nextInt().toByte() })
            5 -> replaced(input, at, 0, input.copyOfRange(at, at + length))
            6 -> number(input, at, random)
            7 -> input.copyOf(at)
            else -> spliced(input, at, length, other, random)
        }
    }

    private fun changed(input: ByteArray, random: Random, change: (Byte) -> Byte): ByteArray {
        val bytes = input.copyOf()
        if (bytes.isEmpty()) return bytes
        repeat(1 + random.small(8)) {
            val at = random.nextInt(bytes.size)
            bytes[at] = change(bytes[at])
        }
        return bytes
    }

    /** Writes an interesting number over the bytes at [at], in either order of bytes. */
    private fun number(input: ByteArray, at: Int, random: Random): ByteArray {
        val isFloat = random.nextInt(3) == 0
        val bits = if (isFloat) {
            random.pick(InterestingNumbers.floats).toRawBits().toLong()
        } else {
            random.pick(InterestingNumbers.whole)
        }
        val size = if (isFloat) 4 else random.pick(SIZES)
        val bigEndian = random.nextInt(3) == 0
        val bytes = ByteArray(minOf(size, input.size - at)) { i ->
            (bits shr 8 * (if (bigEndian) size - 1 - i else i)).toByte()
        }
        return replaced(input, at, bytes.size, bytes)
    }

    private fun spliced(input: ByteArray, at: Int, length: Int, other: ByteArray, random: Random): ByteArray {
        val from = random.nextInt(other.size + 1)
        val to = from + random.nextInt(other.size - from + 1)
        return replaced(input, at, length, other.copyOfRange(from, to))
    }

    /** Returns [input] with [bytes] in the place of [length] of its own. */
    fun replaced(input: ByteArray, at: Int, length: Int, bytes: ByteArray): ByteArray =
        input.copyOfRange(0, at) + bytes + input.copyOfRange(at + length, input.size)

    private val SIZES = listOf(1, 2, 4, 8)
    private val ODD = listOf(0, 1, 9, 10, 13, 27, 32, 34, 47, 92, 0x7F, 0x80, 0x85, 0xC3, 0xE2, 0xEF, 0xFE, 0xFF)
}
