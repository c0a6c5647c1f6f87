package dev.lazyz.geometry

import java.util.concurrent.ThreadLocalRandom

/**
 * Numbers the different triples of whole numbers among those that are added, from 0 in the order of their first
 * appearance: what a reader of meshes needs to find the corners that are one vertex.
 *
 * The numbers depend on the triples and their order alone. A table with open addressing finds them; its hash function is
 * another in each process, so that no file can be made to collide. Cost: constant time an addition, on average; 20 bytes
 * a triple at least. Not thread safe.
 *
 * @param expected how many different triples to make room for at first
 * @throws IllegalArgumentException if [expected] is negative
 */
public class DistinctTriples @JvmOverloads constructor(expected: Int = 0) {
    /** The triples one after the other. */
    private var triples: IntArray

    /** A triple's number plus 1 at the first free place from where its hash points to; 0 where the table is free. */
    private var table: IntArray

    /** How many different triples there are. */
    public var size: Int = 0
        private set

    init {
        require(expected >= 0) { "expected must not be negative: $expected" }
        triples = IntArray(3 * minOf(maxOf(expected, LEAST), MOST))
        table = IntArray(tableSize(triples.size / 3))
    }

    /** Returns the number of the triple, a new one if it is not there yet. */
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

    /** Returns one of the three numbers of a triple; [place] is 0, 1 or 2. */
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

        /** As many as three numbers each fit into an array. */
        const val MOST = (Int.MAX_VALUE - 8) / 3

        /** Secret factors, odd. */
        val A = ThreadLocalRandom.current().nextLong() or 1
        val B = ThreadLocalRandom.current().nextLong() or 1
        val C = ThreadLocalRandom.current().nextLong() or 1

        /** A table at most three quarters full when [count] triples are in it: a power of two. */
        fun tableSize(count: Int): Int = minOf(Integer.highestOneBit(count + count / 3) * 2L, 1L shl 30).toInt()

        /** A secret linear form (multiply-shift hashing by M. Dietzfelbinger), then S. Vigna's mixing of its bits. */
        fun hash(a: Int, b: Int, c: Int): Int {
            var h = a * A + b * B + c * C
            h = (h xor (h ushr 30)) * -0x40a7b892e31b1a47L
            h = (h xor (h ushr 27)) * -0x6b2fb644ecceee15L
            return (h ushr 32).toInt()
        }
    }
}
