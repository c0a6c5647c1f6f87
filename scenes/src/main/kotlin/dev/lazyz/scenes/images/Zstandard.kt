package dev.lazyz.scenes.images

import dev.lazyz.scenes.images.ZstandardBits.check
import dev.lazyz.scenes.images.ZstandardBits.damaged
import java.io.IOException

/**
 * Decodes data compressed by Zstandard (Y. Collet, RFC 8878), without dictionaries; checksums are not compared. There
 * is no maintained decoder in Java that does not access memory by its address. Not thread safe.
 *
 * @param input the file
 * @property at the next byte of [input]
 * @param out receives what is decoded
 */
internal class Zstandard private constructor(
    private val input: ByteArray,
    private var at: Int,
    private val out: ByteArray,
) {
    private var written = 0

    /** Where the frame began in [out], and the distances of the last three matches. */
    private var frameStart = 0
    private val recent = IntArray(3)
    private var huffman: HuffmanTable? = null
    private val tables = arrayOfNulls<StateTable>(KINDS)
    private val literals = ByteArray(MOST_IN_BLOCK)
    private var literalCount = 0

    private fun byte(): Int = input[at++].toInt() and 0xFF

    private fun number(bytes: Int): Long {
        var sum = 0L
        for (i in 0 until bytes) sum = sum or (byte().toLong() shl 8 * i)
        return sum
    }

    private fun frame(look: () -> Unit) {
        val magic = number(4)
        if (magic and -16L == SKIPPABLE) {
            val length = number(4)
            check(length <= input.size - at, "the data is cut short")
            at += length.toInt()
            return
        }
        check(magic == MAGIC, "there is no frame")
        val flags = byte()
        val isSingle = flags and 0x20 != 0
        check(flags and 8 == 0, "the frame is of a later version")
        if (!isSingle) at++
        check(number(DICTIONARY_BYTES[flags and 3]) == 0L, "a dictionary is needed")
        at += if (flags shr 6 == 0) (if (isSingle) 1 else 0) else 1 shl (flags shr 6)
        frameStart = written
        intArrayOf(1, 4, 8).copyInto(recent)
        huffman = null
        tables.fill(null)
        do {
            look()
            val head = number(3).toInt()
            val size = head shr 3
            when (head shr 1 and 3) {
                0 -> literal(input, at, size).also { at += size }
                1 -> repeat(size) { out[written++] = input[at] }.also { at++ }
                2 -> block(at + size)
                else -> damaged("the kind of a block is not known")
            }
        } while (head and 1 == 0)
        if (flags and 4 != 0) at += 4
    }

    private fun literal(from: ByteArray, start: Int, count: Int) {
        from.copyInto(out, written, start, start + count)
        written += count
    }

    private fun block(end: Int) {
        readLiterals()
        var next = 0
        var count = byte()
        if (count >= 0x80) count = if (count == 0xFF) number(2).toInt() + 0x7F00 else (count - 0x80 shl 8) + byte()
        if (count > 0) {
            val modes = byte()
            for (kind in 0 until KINDS) tables[kind] = table(kind, modes shr (6 - 2 * kind) and 3)
            val bits = BackwardBits(input, at, end)
            val states = List(KINDS) { State(tables[it]!!, bits) }
            val (lengths, distances, matches) = states
            for (i in 0 until count) {
                val code = distances.symbol
                val value = (1 shl code) + bits.read(code)
                val match = MATCH_BASES[matches.symbol] + bits.read(MATCH_BITS[matches.symbol])
                val length = LITERAL_BASES[lengths.symbol] + bits.read(LITERAL_BITS[lengths.symbol])
                if (i < count - 1) for (kind in UPDATES) states[kind].update()
                check(next + length <= literalCount, "literals are missing")
                literal(literals, next, length)
                next += length
                copy(distance(value, length), match)
            }
        }
        literal(literals, next, literalCount - next)
        at = end
    }

    /** Returns the distance that [value] stands for, and makes it the most recent one. */
    private fun distance(value: Int, length: Int): Int {
        val place = value - 1 + (if (length == 0) 1 else 0)
        val distance = when {
            value !in 1..3 -> value - 3
            place == 3 -> recent[0] - 1
            else -> recent[place]
        }
        if (value !in 1..3 || place > 1) recent[2] = recent[1]
        if (value !in 1..3 || place > 0) recent[1] = recent[0]
        recent[0] = distance
        return distance
    }

    private fun copy(distance: Int, count: Int) {
        check(distance in 1..written - frameStart, "a match is before the frame")
        for (i in 0 until count) out[written + i] = out[written + i - distance]
        written += count
    }

    private fun readLiterals() {
        val head = byte()
        val form = head shr 2 and 3
        if (head and 2 == 0) {
            val more = if (form and 1 == 0) 0 else (form + 1) / 2
            literalCount = (head shr (if (more == 0) 3 else 4)) + (number(more).toInt() shl 4)
            if (head and 1 == 0) {
                input.copyInto(literals, 0, at, at + literalCount)
                at += literalCount
            } else {
                literals.fill(input[at++], 0, literalCount)
            }
            return
        }
        val width = if (form < 2) 10 else 6 + 4 * (form - 1) + 4
        val sizes = number(if (form < 2) 2 else form + 1) shl 4 or (head shr 4).toLong()
        literalCount = (sizes and (1L shl width) - 1).toInt()
        val end = at + (sizes shr width).toInt()
        check(literalCount <= MOST_IN_BLOCK, "a block is too long")
        if (head and 1 == 0) huffman = HuffmanTable(weights())
        val table = huffman ?: damaged("a block needs the codes of another")
        if (form == 0) {
            table.decode(BackwardBits(input, at, end), literals, 0, literalCount)
        } else {
            val lengths = List(3) { number(2).toInt() }
            val part = (literalCount + 3) / 4
            for (i in 0 until 4) {
                val stop = if (i < 3) at + lengths[i] else end
                val until = if (i < 3) part * (i + 1) else literalCount
                table.decode(BackwardBits(input, at, stop), literals, part * i, until)
                at = stop
            }
        }
        at = end
    }

    /** Reads the weights of Huffman codes: plain, or as two states that take turns. */
    private fun weights(): List<Int> {
        val head = byte()
        if (head >= 0x80) {
            val first = at
            at += (head - 0x7F + 1) / 2
            return List(head - 0x7F) { input[first + it / 2].toInt() shr (if (it % 2 == 0) 4 else 0) and 15 }
        }
        val end = at + head
        val table = readTable(MOST_WEIGHT_LOG)
        val bits = BackwardBits(input, at, end)
        val states = List(2) { State(table, bits) }
        val weights = ArrayList<Int>()
        while (weights.size <= HuffmanTable.MOST_WEIGHTS) {
            val state = states[weights.size % 2]
            weights.add(state.symbol)
            state.update()
            if (bits.left < 0) {
                weights.add(states[weights.size % 2].symbol)
                break
            }
        }
        at = end
        return weights
    }

    private fun readTable(mostLog: Int): StateTable {
        val bits = ForwardBits(input, at)
        return StateTable.read(bits, mostLog).also { at = bits.end }
    }

    private fun table(kind: Int, mode: Int): StateTable = when (mode) {
        0 -> StateTable.of(USUAL[kind], if (kind == 1) 5 else 6)
        1 -> StateTable.single(byte())
        2 -> readTable(if (kind == 1) 8 else 9)
        else -> tables[kind] ?: damaged("a block needs the tables of another")
    }

    companion object {
        private const val MAGIC = 0xFD2FB528L
        private const val SKIPPABLE = 0x184D2A50L
        private const val MOST_IN_BLOCK = 1 shl 17
        private const val MOST_WEIGHT_LOG = 6
        private val DICTIONARY_BYTES = intArrayOf(0, 1, 2, 4)

        /** Lengths of literals, distances, lengths of matches; and the order in which their states go on. */
        private const val KINDS = 3
        private val UPDATES = intArrayOf(0, 2, 1)

        private val LITERAL_BITS =
            IntArray(16) + intArrayOf(1, 1, 1, 1, 2, 2, 3, 3, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)
        private val MATCH_BITS =
            IntArray(32) + intArrayOf(1, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)
        private val LITERAL_BASES = bases(LITERAL_BITS, 0)
        private val MATCH_BASES = bases(MATCH_BITS, 3)

        /** The usual shares of symbols. */
        private val USUAL = listOf(
            intArrayOf(4, 3) + IntArray(11) { 2 } + IntArray(3) { 1 } + IntArray(9) { 2 } + intArrayOf(3, 2) +
                IntArray(5) { 1 } + IntArray(4) { -1 },
            IntArray(6) { 1 } + IntArray(3) { 2 } + IntArray(15) { 1 } + IntArray(5) { -1 },
            intArrayOf(1, 4, 3) + IntArray(6) { 2 } + IntArray(37) { 1 } + IntArray(7) { -1 },
        )

        private fun bases(widths: IntArray, first: Int): IntArray {
            var next = first
            return IntArray(widths.size) { next.also { _ -> next += 1 shl widths[it] } }
        }

        /**
         * Returns the first [size] bytes of what the [length] bytes of [input] from [start] on contain.
         *
         * @param look called for each block; throws to end the decoding
         * @throws IOException if the data is damaged; an [IndexOutOfBoundsException] if it is cut short or too long
         */
        fun decode(input: ByteArray, start: Int, length: Int, size: Int, look: () -> Unit): ByteArray {
            val decoder = Zstandard(input.copyOfRange(start, start + length), 0, ByteArray(size))
            while (decoder.written < size) decoder.frame(look)
            return decoder.out
        }
    }
}
