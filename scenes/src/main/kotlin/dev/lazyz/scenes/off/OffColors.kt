package dev.lazyz.scenes.off

import dev.lazyz.Rgba
import dev.lazyz.scenes.collections.Floats
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.images.SrgbDecoding
import kotlin.math.abs

/**
 * Colours as stored in the file: integers in 0..255, or fractions in 0..1. A colour such as `1 0 0` can be either. It
 * is read as integers if some other colour has an integer above 1 and no colour has a fraction. All channels except
 * alpha are sRGB-encoded. Not thread safe.
 */
internal class OffColors {
    private val numbers = Floats()

    /** For each colour: [SURELY_WHOLE], [SURELY_FRACTIONS] or [EITHER]. */
    private val kinds = Ints()
    private var haveWhole = false
    private var haveFractions = false

    /** Number of colours. */
    val size: Int get() = kinds.size

    /** Adds a colour of [count] numbers, three or four, which begin at index [from] of [line]. */
    fun add(line: OffLine, from: Int, count: Int) {
        var kind = EITHER
        for (i in from until from + count) {
            numbers.add(line.numbers[i].toFloat())
            if (line.isFraction(i)) {
                kind = SURELY_FRACTIONS
            } else if (line.numbers[i] > 1.0 && kind == EITHER) {
                kind = SURELY_WHOLE
            }
        }
        if (count == 3) numbers.add(OPAQUE)
        kinds.add(kind)
        if (kind == SURELY_WHOLE) haveWhole = true
        if (kind == SURELY_FRACTIONS) haveFractions = true
    }

    /** Adds white, for an element without a colour. */
    fun addWhite() {
        repeat(3) { numbers.add(1f) }
        numbers.add(OPAQUE)
        kinds.add(SURELY_FRACTIONS)
    }

    /**
     * Whether numbers that nothing declares are colours: all are in the range of colours, and they cannot be normals.
     * Call it only after all colours were added.
     */
    fun areEvident(): Boolean {
        val most = if (haveWhole && !haveFractions) MOST_CODE else 1f
        for (i in 0 until numbers.size) {
            val isMissing = i % 4 == 3 && numbers[i] == OPAQUE
            if (!isMissing && numbers[i] !in 0f..most) return false
        }
        return !couldBeNormals()
    }

    /** Whether the colours have length 1 and no alpha, and either are all the same or do not all lie on the axes. */
    private fun couldBeNormals(): Boolean {
        var areSame = true
        var areOnAxes = true
        for (color in 0 until size) {
            var square = 0f
            for (channel in 0 until 3) {
                val number = numbers[4 * color + channel]
                square += number * number
                if (number != 0f && number != 1f) areOnAxes = false
                if (number != numbers[channel]) areSame = false
            }
            if (abs(square - 1f) > LENGTH_TOLERANCE || numbers[4 * color + 3] != OPAQUE) return false
        }
        return areSame || !areOnAxes
    }

    /**
     * Returns red (0), green (1), blue (2) or alpha (3) of a colour, linear. Call it only after all colours were added.
     */
    fun channel(color: Int, channel: Int): Float {
        val number = numbers[4 * color + channel]
        val kind = kinds[color]
        val isCode = kind == SURELY_WHOLE || (kind == EITHER && haveWhole && !haveFractions)
        return when {
            channel == 3 && number == OPAQUE -> 1f
            channel == 3 -> if (isCode) number / MOST_CODE else number
            isCode -> SrgbDecoding.decodeByte(number.coerceIn(0f, MOST_CODE).toInt())
            else -> Rgba.linearOf(number.toDouble())
        }
    }

    private companion object {
        const val EITHER = 0
        const val SURELY_WHOLE = 1
        const val SURELY_FRACTIONS = 2
        const val MOST_CODE = 255f

        /** Difference of a normal's squared length from 1, because files round their numbers. */
        const val LENGTH_TOLERANCE = 0.01f

        /** Stands for a missing alpha. */
        const val OPAQUE = -1f
    }
}
