package dev.lazyz.scenes.text

/**
 * Converts a decimal number in a byte array to binary with ordinary arithmetic, if the result is certain to be the
 * nearest, which is also the result of Java's parser (W. D. Clinger, "How to Read Floating Point Numbers Accurately",
 * 1990, section 3). An instance can be reused. Not thread safe.
 */
internal class Decimal {
    private var isNegative = false

    /** The number is [digits] times ten to the power of [exponent]. */
    private var digits = 0L
    private var exponent = 0

    /**
     * Returns the float nearest to the number in [from] until [until]; NaN if it is not a number or the result is
     * uncertain.
     */
    fun float(bytes: ByteArray, from: Int, until: Int): Float {
        if (!scan(bytes, from, until) || exponent < -2 * MOST_POWER) return Float.NaN
        val product = if (exponent < -MOST_POWER) {
            digits / POWERS[MOST_POWER] / POWERS[-exponent - MOST_POWER]
        } else {
            product()
        }

        // The product is wrong by less than 3 units in its last place, so the float is certain unless the product is
        // close to the midpoint of two floats. Subnormal floats have fewer digits and other midpoints, so they count
        // as uncertain
        val rest = product.toRawBits() and REST
        val isUncertain = rest in HALF - DOUBT..HALF + DOUBT || (product < LEAST_FLOAT && digits != 0L)
        if (isUncertain) return Float.NaN
        return (if (isNegative) -product else product).toFloat()
    }

    /**
     * Returns the double nearest to the number in [from] until [until]; NaN if it is not a number or the result is
     * uncertain.
     */
    fun double(bytes: ByteArray, from: Int, until: Int): Double {
        if (!scan(bytes, from, until) || digits > MOST_EXACT || exponent < -MOST_POWER) return Double.NaN
        val product = product()
        return if (isNegative) -product else product
    }

    /** Rounds only once, if [digits] is exact as a double. */
    private fun product(): Double = if (exponent < 0) digits / POWERS[-exponent] else digits * POWERS[exponent]

    /** Parses a number; returns false if it is not a number, or has too many digits or too large an exponent. */
    private fun scan(bytes: ByteArray, from: Int, until: Int): Boolean {
        var at = from
        isNegative = at < until && bytes[at] == MINUS
        if (isNegative || (at < until && bytes[at] == PLUS)) at++

        // The digits; leading zeros do not count
        var value = 0L
        val start = at
        var point = -1
        while (at < until) {
            val digit = bytes[at] - ZERO
            if (digit in 0..9) {
                if (value >= ROOM) return false
                value = 10 * value + digit
            } else if (bytes[at] == POINT && point < 0) {
                point = at
            } else {
                break
            }
            at++
        }
        val count = at - start - (if (point < 0) 0 else 1)
        if (count == 0) return false
        digits = value
        exponent = if (point < 0) 0 else point + 1 - at

        // The power of ten
        if (at < until) {
            if (bytes[at] != SMALL_E && bytes[at] != LARGE_E) return false
            at++
            val isDown = at < until && bytes[at] == MINUS
            if (isDown || (at < until && bytes[at] == PLUS)) at++
            if (at == until || until - at > 3) return false
            var power = 0
            while (at < until) {
                val digit = bytes[at++] - ZERO
                if (digit !in 0..9) return false
                power = 10 * power + digit
            }
            exponent += if (isDown) -power else power
        }
        return exponent <= MOST_POWER
    }

    private companion object {
        const val ZERO = '0'.code
        const val POINT = '.'.code.toByte()
        const val MINUS = '-'.code.toByte()
        const val PLUS = '+'.code.toByte()
        const val SMALL_E = 'e'.code.toByte()
        const val LARGE_E = 'E'.code.toByte()

        /** From this value on, another digit could overflow. */
        const val ROOM = Long.MAX_VALUE / 10 - 1

        /** Up to this value, every integer is exact as a double. */
        const val MOST_EXACT = 1L shl 53

        /** Up to this exponent, powers of ten are exact as doubles. */
        const val MOST_POWER = 22
        val POWERS = DoubleArray(MOST_POWER + 1).also { powers ->
            powers[0] = 1.0
            for (i in 1..MOST_POWER) powers[i] = powers[i - 1] * 10.0
        }

        /**
         * The bits of a double that a float does not have, their midpoint, and the distance from it that makes a
         * float uncertain.
         */
        const val REST = (1L shl 29) - 1
        const val HALF = 1L shl 28
        const val DOUBT = 8L

        /** The smallest normal float: from this value on, floats have full precision. */
        const val LEAST_FLOAT = 1.1754945e-38
    }
}

/**
 * Parses numbers as various programs write them in mesh files. NaN and infinity are accepted in C's spellings (`nan`,
 * `-nan(ind)`, `inf`) and in Microsoft's (`1.#QNAN`, `1.#INF`), ignoring case. Some exporters write the sign before
 * the `e` by mistake: `3.1+e2` is read as `3.1e+2`.
 */
internal object TextNumbers {
    /** Returns the number that [word] represents, or null if it is not a number. */
    fun parse(word: String): Double? = word.toDoubleOrNull() ?: named(word) ?: corrected(word)?.toDoubleOrNull()

    /** Returns the float nearest to the number that [word] represents, or null if it is not a number. */
    fun parseFloat(word: String): Float? =
        word.toFloatOrNull() ?: named(word)?.toFloat() ?: corrected(word)?.toFloatOrNull()

    /** Returns [word] with the sign behind the `e`, or null if it is not in front of it. */
    private fun corrected(word: String): String? {
        val e = word.indexOf('e', ignoreCase = true)
        if (e < 2 || word[e - 1] !in "+-" || word.last() !in '0'..'9') return null
        return word.substring(0, e - 1) + "e" + word[e - 1] + word.substring(e + 1)
    }

    private fun named(word: String): Double? {
        val isNegative = word.startsWith("-")
        val name = word.removePrefix("-").removePrefix("+").lowercase()
        return when {
            name.startsWith("nan") || name.startsWith("1.#qnan") || name.startsWith("1.#snan") -> Double.NaN
            name.startsWith("1.#ind") -> Double.NaN
            name == "inf" || name == "infinity" || name.startsWith("1.#inf") ->
                if (isNegative) Double.NEGATIVE_INFINITY else Double.POSITIVE_INFINITY
            else -> null
        }
    }

    /**
     * Returns a remedy for [word], which is not a number, or null. A comma that is not between digits is no decimal
     * one.
     */
    fun remedy(word: String): String? = when {
        ',' !in word -> null
        '.' in word || word.count { it == ',' } > 1 || word.startsWith(',') || word.endsWith(',') ->
            "write spaces between numbers, not commas"
        else -> "write numbers with a decimal point, not a comma"
    }
}
