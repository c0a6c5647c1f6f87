package dev.lazyz.geometry

import java.util.concurrent.ThreadLocalRandom

/**
 * Assigns numbers to distinct triples of integers, from 0 in the order of their first appearance. Readers of meshes use
 * it to find the corners that are the same vertex.
 *
 * The numbers depend only on the triples and their order. The implementation is a hash table with open addressing. Its
 * hash function is different in each process, so that no file can be constructed to cause collisions. Cost: constant
 * time for each addition, on average; at least 20 bytes for each distinct triple. Not thread safe.
 *
 * @param expected initial capacity, in distinct triples
 * @throws IllegalArgumentException if [expected] is negative
 */
public class DistinctTriples @JvmOverloads constructor(expected: Int = 0) {
    /** The triples, three numbers for each. */
    private var triples: IntArray

    /**
     * The number of a triple plus 1, at the first free place from the index given by its hash on; 0 if the place is
     * free.
     */
    private var table: IntArray

    /** Number of distinct triples. */
    public var size: Int = 0
        private set

    init {
        require(expected >= 0) { "expected must not be negative: $expected" }
        triples = IntArray(3 * minOf(maxOf(expected, LEAST), MOST))
        table = IntArray(tableSize(triples.size / 3))
    }

    /**
     * Returns the number of the triple ([a], [b], [c]); assigns the next number if it is new.
     *
     * @throws IllegalStateException if there would be more than 715,827,879 distinct triples
     */
    public fun add(a: Int, b: Int, c: Int): Int {
        var place = hash(a, b, c) and table.size - 1
        while (true) {
            val number = table[place] - 1
            if (number < 0) break
            val at = 3 * number
            if (triples[at] == a && triples[at + 1] == b && triples[at + 2] == c) return number
            place = place + 1 and table.size - 1
        }
        return append(a, b, c, place)
    }

    /**
     * Returns the number of the point ([x], [y], [z]), whose coordinates are stored as bits, see [get]. -0 equals 0,
     * and all NaNs are equal. Points that are close together but not equal are different. Throws like [add].
     */
    public fun addPoint(x: Float, y: Float, z: Float): Int =
        add((x + 0f).toBits(), (y + 0f).toBits(), (z + 0f).toBits())

    /** Returns one of the three integers of triple [number], 0 until [size]; [place] is 0, 1 or 2. */
    public fun get(number: Int, place: Int): Int = triples[3 * number + place]

    override fun toString(): String = "DistinctTriples($size)"

    private fun append(a: Int, b: Int, c: Int, place: Int): Int {
        if (3 * size == triples.size) {
            grow()
            table[freePlace(a, b, c)] = size + 1
        } else {
            table[place] = size + 1
        }
        triples[3 * size] = a
        triples[3 * size + 1] = b
        triples[3 * size + 2] = c
        return size++
    }

    private fun grow() {
        check(size < MOST) { "more than $MOST triples" }
        triples = triples.copyOf(3 * minOf(size + size / 2, MOST))
        val tableSize = tableSize(triples.size / 3)
        if (tableSize == table.size) return
        table = IntArray(tableSize)
        for (number in 0 until size) {
            val at = 3 * number
            table[freePlace(triples[at], triples[at + 1], triples[at + 2])] = number + 1
        }
    }

    private fun freePlace(a: Int, b: Int, c: Int): Int {
        var place = hash(a, b, c) and table.size - 1
        while (table[place] != 0) place = place + 1 and table.size - 1
        return place
    }

    private companion object {
        const val LEAST = 16

        /** Maximum number of triples, limited by the size of an array. */
        const val MOST = (Int.MAX_VALUE - 8) / 3

        /** Random odd factors, different in each process. */
        val A = ThreadLocalRandom.current().nextLong() or 1
        val B = ThreadLocalRandom.current().nextLong() or 1
        val C = ThreadLocalRandom.current().nextLong() or 1

        /** Returns the size of a table that is at most three quarters full with [count] triples: a power of two. */
        fun tableSize(count: Int): Int = minOf(Integer.highestOneBit(count + count / 3) * 2L, 1L shl 30).toInt()

        /**
         * A linear form with random factors (multiply-shift hashing by M. Dietzfelbinger), followed by S. Vigna's bit
         * mixing.
         */
        fun hash(a: Int, b: Int, c: Int): Int {
            var h = a * A + b * B + c * C
            h = (h xor (h ushr 30)) * -0x40a7b892e31b1a47L
            h = (h xor (h ushr 27)) * -0x6b2fb644ecceee15L
            return (h ushr 32).toInt()
        }
    }
}
