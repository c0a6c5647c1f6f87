package dev.lazyz.scenes.fuzz.mutations

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Random

/** Changes the facets of a binary STL file, and the number of them. */
internal object StlMutations : Mutations {
    private const val HEADER = 84
    private const val FACET = 50

    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray? {
        if (input.size < HEADER || input.drop(HEADER - 8).none { it.toInt() == 0 }) return null
        val facets = (input.size - HEADER) / FACET
        val at = HEADER + FACET * random.nextInt(facets + 1)
        val length = if (at + FACET <= input.size) FACET else 0
        return when (random.nextInt(5)) {
            0 -> counted(input, random.pick(InterestingNumbers.whole))
            1 -> counted(input, facets + random.nextLong() % 3)
            2 -> ByteMutations.replaced(input, at, length, ByteArray(0)).let { counted(it, facets - 1L) }
            3 -> {
                val copies = 1 + random.small(100)
                val facet = input.copyOfRange(at, at + length)
                val all = ByteArray(copies * length) { facet[it % length] }
                counted(ByteMutations.replaced(input, at, 0, all), facets + copies.toLong())
            }
            else -> withNumber(input, at, length, random)
        }
    }

    private fun counted(input: ByteArray, count: Long): ByteArray = input.copyOf().also {
        ByteBuffer.wrap(it).order(ByteOrder.LITTLE_ENDIAN).putInt(HEADER - 4, count.toInt())
    }

    private fun withNumber(input: ByteArray, at: Int, length: Int, random: Random): ByteArray {
        val bytes = input.copyOf()
        if (length > 0) {
            val number = random.pick(InterestingNumbers.floats)
            ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putFloat(at + 4 * random.nextInt(12), number)
        }
        return bytes
    }
}
