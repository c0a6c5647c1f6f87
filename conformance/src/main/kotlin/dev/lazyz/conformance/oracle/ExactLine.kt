package dev.lazyz.conformance.oracle

import dev.lazyz.geometry.FillRule
import java.math.BigDecimal
import java.math.BigInteger
import java.math.MathContext

/**
 * A line on the 1/256 pixel grid with the coverage and depth of contract rules 2.10 and 4.6 in exact rational
 * arithmetic: the oracle for lines.
 *
 * Implements the rules independently of set-up: every sample is decided on its own. Immutable and thread safe.
 *
 * @param ends x, y, depth of both ends: x and y in grid steps within 2^27 of the origin, depth in 0..2^31-1
 * @param width width of the line in pixels
 * @throws IllegalArgumentException if there are not six numbers
 */
public class ExactLine(ends: IntArray, width: Double) : ExactSurface {
    private val ends = ends.copyOf()
    private val points: List<ExactPoint>
    private val quad: ExactPolygon
    private val columns: IntRange
    private val runX: Long
    private val runY: Long

    init {
        require(ends.size == 6) { "a line has two ends of three numbers: ${ends.size}" }
        points = listOf(ExactPoint(ends[0], ends[1], 0, 1.0), ExactPoint(ends[3], ends[4], 0, 1.0))
        runX = ends[3].toLong() - ends[0]
        runY = ends[4].toLong() - ends[1]
        val half = ExactPoint.halfSize(width)
        val isPoint = runX == 0L && runY == 0L
        val ux = if (isPoint) half.toInt() else share(half, runX)
        val uy = if (isPoint) 0 else share(half, runY)
        val x0 = ends[0]
        val y0 = ends[1]
        val x1 = ends[3]
        val y1 = ends[4]
        quad = ExactPolygon(
            listOf(
                intArrayOf(
                    x0 - ux - uy, y0 - uy + ux, 0, x1 + ux - uy, y1 + uy + ux, 0,
                    x1 + ux + uy, y1 + uy - ux, 0, x0 - ux + uy, y0 - uy - ux, 0,
                ),
            ),
            FillRule.NON_ZERO,
        )
        val reach = 2 * half.toInt() + 512
        columns = Math.floorDiv(minOf(x0, x1) - reach, 256)..Math.floorDiv(maxOf(x0, x1) + reach, 256)
    }

    private fun share(half: Long, run: Long): Int {
        val length = StrictMath.sqrt((runX * runX + runY * runY).toDouble())
        val size = StrictMath.ceil((half * Math.abs(run)).toDouble() / length).toInt()
        return if (run < 0) -size else size
    }

    override fun coverage(x: Int, y: Int): Coverage {
        val isSpanned = (columns.first..x).any { covers(it, y) } && (x..columns.last).any { covers(it, y) }
        return if (isSpanned) Coverage.COVERED else Coverage.UNCOVERED
    }

    private fun covers(x: Int, y: Int): Boolean =
        quad.covers(x, y) || points.any { it.coverage(x, y) == Coverage.COVERED }

    override fun depthError(x: Int, y: Int, depth: Int): Double {
        val square = big(runX) * big(runX) + big(runY) * big(runY)
        val along = big(runX) * big(256L * x + 128 - ends[0]) + big(runY) * big(256L * y + 128 - ends[1])
        val part = along.max(BigInteger.ZERO).min(square)
        if (square.signum() == 0) return Math.abs(depth.toDouble() - ends[2])
        val error = part * big(ends[5].toLong() - ends[2]) - big(depth.toLong() - ends[2]) * square
        return BigDecimal(error.abs()).divide(BigDecimal(square), MathContext(40)).toDouble()
    }

    override fun toString(): String = "ExactLine(${ends.toList()}, $quad)"

    private companion object {
        fun big(value: Long): BigInteger = BigInteger.valueOf(value)
    }
}
