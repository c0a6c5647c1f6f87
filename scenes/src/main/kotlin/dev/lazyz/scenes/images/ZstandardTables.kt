package dev.lazyz.scenes.images

import java.io.IOException

/** What the parts of [Zstandard] share. */
internal object ZstandardBits {
    /** Returns the number of the highest bit of [number] that is set. */
    fun log(number: Int): Int = 31 - Integer.numberOfLeadingZeros(number)

    /** Returns [count] bits, 0..31, from bit [from] of [input] on. */
    fun of(input: ByteArray, from: Long, count: Int): Int {
        var sum = 0L
        val first = (from ushr 3).toInt()
        for (i in 0..(((from and 7) + count - 1) shr 3).toInt()) {
            sum = sum or ((input[first + i].toLong() and 0xFF) shl 8 * i)
        }
        return (sum ushr (from and 7).toInt() and (1L shl count) - 1).toInt()
    }

    fun check(isRight: Boolean, problem: String) {
        if (!isRight) damaged(problem)
    }

    fun damaged(problem: String): Nothing = throw IOException("Zstandard: $problem")
}

/** Bits of [input] from the first one of byte [start] on. */
internal class ForwardBits(private val input: ByteArray, private val start: Int) {
    private var bit = 0L

    /** The next whole byte. */
    val end: Int get() = start + ((bit + 7) / 8).toInt()

    fun read(count: Int): Int = ZstandardBits.of(input, start * 8L + bit, count).also { bit += count }

    fun back() {
        bit--
    }
}

/** Bits from the last one on, below the mark: the highest bit that is set. Beyond the first one, zeros follow. */
internal class BackwardBits(private val input: ByteArray, start: Int, end: Int) {
    private val first = start * 8L

    /** How many bits are left; below 0 behind the first one. */
    var left: Int

    init {
        ZstandardBits.check(end > start && input[end - 1].toInt() != 0, "bits have no end")
        left = 8 * (end - start) - 8 + ZstandardBits.log(input[end - 1].toInt() and 0xFF)
    }

    fun read(count: Int): Int {
        left -= count
        return peekBelow(count)
    }

    /** Returns the next bits without going on. */
    fun peek(count: Int): Int {
        left -= count
        return peekBelow(count).also { left += count }
    }

    private fun peekBelow(count: Int): Int = when {
        left >= 0 -> ZstandardBits.of(input, first + left, count)
        left + count > 0 -> ZstandardBits.of(input, first, left + count) shl -left
        else -> 0
    }
}

/** A state that goes through a [table] by the [bits]. */
internal class State(private val table: StateTable, private val bits: BackwardBits) {
    private var state = bits.read(table.log)
    val symbol: Int get() = table.symbols[state].toInt()

    fun update() {
        state = table.bases[state] + bits.read(table.widths[state].toInt())
    }
}

/** A table of finite state entropy: for each state its symbol, and where the next one is. */
internal class StateTable private constructor(val log: Int) {
    val symbols = ByteArray(1 shl log)
    val widths = ByteArray(1 shl log)
    val bases = IntArray(1 shl log)

    companion object {
        private const val MOST_SYMBOL = 52

        /** Returns a table of one symbol. */
        fun single(symbol: Int): StateTable {
            ZstandardBits.check(symbol <= MOST_SYMBOL, "a symbol is too large")
            return StateTable(0).also { it.symbols[0] = symbol.toByte() }
        }

        /** Returns a table of the [shares] of symbols of 2 to the power of [log]; -1 is less than one. */
        fun of(shares: IntArray, log: Int): StateTable {
            val table = StateTable(log)
            val size = 1 shl log
            val next = IntArray(shares.size) { Math.abs(shares[it]) }
            var high = size
            for (symbol in shares.indices) if (shares[symbol] < 0) table.symbols[--high] = symbol.toByte()
            var place = 0
            for (symbol in shares.indices) {
                for (i in 0 until shares[symbol]) {
                    table.symbols[place] = symbol.toByte()
                    do place = place + (size shr 1) + (size shr 3) + 3 and size - 1 while (place >= high)
                }
            }
            for (state in 0 until size) {
                val count = next[table.symbols[state].toInt()]++
                val width = log - ZstandardBits.log(count)
                table.widths[state] = width.toByte()
                table.bases[state] = (count shl width) - size
            }
            return table
        }

        /** Reads a table whose size is at most 2 to the power of [mostLog]. */
        fun read(bits: ForwardBits, mostLog: Int): StateTable {
            val log = bits.read(4) + 5
            ZstandardBits.check(log <= mostLog, "a table is too large")
            val shares = ArrayList<Int>()
            var rest = 1 shl log
            while (rest > 0 && shares.size <= MOST_SYMBOL) {
                val width = ZstandardBits.log(rest + 1) + 1
                val low = (1 shl width - 1) - 1
                val threshold = (1 shl width) - 2 - rest
                var value = bits.read(width)
                if (value and low < threshold) {
                    bits.back()
                    value = value and low
                } else if (value > low) {
                    value -= threshold
                }
                shares.add(value - 1)
                rest -= Math.abs(value - 1)
                var zeros = if (value == 1) 3 else 0
                while (zeros == 3 && shares.size <= MOST_SYMBOL) {
                    zeros = bits.read(2)
                    for (i in 0 until zeros) shares.add(0)
                }
            }
            ZstandardBits.check(rest == 0 && shares.size <= MOST_SYMBOL + 1, "a table is damaged")
            return of(shares.toIntArray(), log)
        }
    }
}

/** Huffman codes. The [weights] are those of all symbols but the last one, whose weight completes the sum. */
internal class HuffmanTable(weights: List<Int>) {
    private val sum = weights.sumOf { if (it == 0) 0 else 1 shl it - 1 }
    private val width = ZstandardBits.log(sum) + 1

    init {
        ZstandardBits.check(width in 1..MOST_WIDTH && weights.size <= MOST_WEIGHTS, "codes are damaged")
    }

    private val symbols = ByteArray(1 shl width)
    private val widths = ByteArray(1 shl width)

    init {
        val rest = (1 shl width) - sum
        val all = weights + (ZstandardBits.log(rest) + 1)
        var at = 0
        for (weight in 1..width) {
            for (symbol in all.indices) {
                if (all[symbol] != weight) continue
                symbols.fill(symbol.toByte(), at, at + (1 shl weight - 1))
                widths.fill((width + 1 - weight).toByte(), at, at + (1 shl weight - 1))
                at += 1 shl weight - 1
            }
        }
        ZstandardBits.check(at == 1 shl width, "codes are not complete")
    }

    /** Decodes the symbols of [out] in [from] until [until]; they must need all [bits]. */
    fun decode(bits: BackwardBits, out: ByteArray, from: Int, until: Int) {
        for (i in from until until) {
            val place = bits.peek(width)
            out[i] = symbols[place]
            bits.left -= widths[place]
        }
        ZstandardBits.check(bits.left == 0, "codes do not end with their block")
    }

    companion object {
        /** The most codes but the last one. */
        const val MOST_WEIGHTS: Int = 255
        private const val MOST_WIDTH = 11
    }
}
