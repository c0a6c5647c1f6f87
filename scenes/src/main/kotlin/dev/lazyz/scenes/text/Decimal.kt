package dev.lazyz.scenes.text

/**
 * A decimal number within bytes, made a binary one by the machine's arithmetic where that is certain to give the nearest,
 * which is what Java's own parser gives (W. D. Clinger, "How to Read Floating Point Numbers Accurately", 1990, section 3).
 * Used over and over. Not thread safe.
 */
internal class Decimal {
    private var isNegative = false

    /** The number is these digits times ten to the power of [exponent]. */
    private var digits = 0L
    private var exponent = 0

    /** Returns the float nearest to the number from [from] until [until]; NaN if it is none, or one that is uncertain. */
    fun float(bytes: ByteArray, from: Int, until: Int): Float {
        if (!scan(bytes, from, until) || exponent < -2 * MOST_POWER) return Float.NaN
        val product = if (exponent < -MOST_POWER) {
            digits / POWERS[MOST_POWER] / POWERS[-exponent - MOST_POWER]
        } else {
            product()
        }

        // The product is off by less than 3 in its last place, so the float is certain unless it is close to the middle
        // between two floats; a float that has fewer digits for being so small has another middle
        val rest = product.toRawBits() and REST
        val isUncertain = rest in HALF - DOUBT..HALF + DOUBT || (product < LEAST_FLOAT && digits != 0L)
        if (isUncertain) return Float.NaN
        return (if (isNegative) -product else product).toFloat()
    }

    /** Returns the double nearest to the number from [from] until [until]; NaN if it is none, or one that is uncertain. */
    fun double(bytes: ByteArray, from: Int, until: Int): Double {
        if (!scan(bytes, from, until) || digits > MOST_EXACT || exponent < -MOST_POWER) return Double.NaN
        val product = product()
        return if (isNegative) -product else product
    }

    /** One rounding, if the digits are a double. */
    private fun product(): Double = if (exponent < 0) digits / POWERS[-exponent] else digits * POWERS[exponent]

    /** Takes a number apart; false if it is none, or has too many digits or too large an exponent. */
    private fun scan(bytes: ByteArray, from: Int, until: Int): Boolean {
        var at = from
        isNegative = at < until && bytes[at] == MINUS
        if (isNegative || (at < until && bytes[at] == PLUS)) at++

        // The digits, of which leading zeros do not count
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

        /** From here on there may be no room for a digit more. */
        const val ROOM = Long.MAX_VALUE / 10 - 1

        /** Up to here every whole number is a double. */
        const val MOST_EXACT = 1L shl 53

        /** Powers of ten up to here are doubles. */
        const val MOST_POWER = 22
        val POWERS = DoubleArray(MOST_POWER + 1).also { powers ->
            powers[0] = 1.0
            for (i in 1..MOST_POWER) powers[i] = powers[i - 1] * 10.0
        }

        /** The places of a double that a float does not have, their middle, and how far from it a float is certain. */
        const val REST = (1L shl 29) - 1
        const val HALF = 1L shl 28
        const val DOUBT = 8L

        /** From here on floats have all their places. */
        const val LEAST_FLOAT = 1.1754945e-38
    }
}
