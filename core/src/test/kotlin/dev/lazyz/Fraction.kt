package dev.lazyz

import java.math.BigDecimal
import java.math.BigInteger

/** A rational number, for exact results in tests. Not reduced, so only suitable for short calculations. */
class Fraction(private val top: BigInteger, private val bottom: BigInteger) : Comparable<Fraction> {
    constructor(value: Long) : this(BigInteger.valueOf(value), BigInteger.ONE)

    init {
        require(bottom.signum() != 0)
    }

    operator fun plus(other: Fraction): Fraction = Fraction(
        top * other.bottom + other.top * bottom,
        bottom * other.bottom
    )

    operator fun minus(other: Fraction): Fraction = Fraction(
        top * other.bottom - other.top * bottom,
        bottom * other.bottom
    )

    operator fun times(other: Fraction): Fraction = Fraction(top * other.top, bottom * other.bottom)

    operator fun div(other: Fraction): Fraction = Fraction(top * other.bottom, bottom * other.top)

    fun abs(): Fraction = Fraction(top.abs(), bottom.abs())

    override fun compareTo(other: Fraction): Int = (this - other).signum()

    fun signum(): Int = top.signum() * bottom.signum()

    /** Accurate to about 17 digits, for messages and statistics. */
    fun toDouble(): Double = BigDecimal(top).divide(BigDecimal(bottom), java.math.MathContext(40)).toDouble()

    override fun toString(): String = toDouble().toString()

    companion object {
        val ZERO: Fraction = Fraction(0)

        /** The exact value of a double. */
        fun of(value: Double): Fraction {
            val decimal = BigDecimal(value)
            val unscaled = decimal.unscaledValue()
            val power = BigInteger.TEN.pow(Math.abs(decimal.scale()))
            return if (decimal.scale() >= 0) Fraction(unscaled, power) else Fraction(unscaled * power, BigInteger.ONE)
        }

        /** Barycentric coordinates of [p] in the triangle [a], [b], [c]; null if it has no area. */
        fun barycentric(a: GridPoint, b: GridPoint, c: GridPoint, p: GridPoint): List<Fraction>? {
            val area = c.side(a, b)
            if (area == 0L) return null
            return listOf(p.side(b, c), p.side(c, a), p.side(a, b)).map { Fraction(it) / Fraction(area) }
        }

        fun sum(terms: List<Fraction>): Fraction = terms.reduce { a, b -> a + b }
    }
}
