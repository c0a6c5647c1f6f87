package dev.lazyz.drawing.strokes

import kotlin.math.round

/**
 * Divides polylines into dashes of about the same length. A polyline begins and ends with a dash, so that corners of
 * dashed lines are closed. Immutable.
 *
 * @param dash length of a dash, pixels
 * @param gap length of a gap, pixels
 */
internal class Dashes(private val dash: Double, private val gap: Double) {
    /** Calls [action] with the points of each dash of [line], x and y in turn. */
    fun forEach(line: DoubleArray, action: (DoubleArray) -> Unit) {
        val length = (2 until line.size step 2).sumOf { step(line, it) }
        val gaps = round((length - dash) / (dash + gap))
        if (gaps < 1.0) return action(line)

        // Stretch or shrink the pattern, so that it fits
        val scale = length / ((gaps + 1) * dash + gaps * gap)
        val period = scale * (dash + gap)
        for (number in 0..gaps.toInt()) part(line, number * period, number * period + scale * dash)?.let(action)
    }

    /** Returns the part of [line] between two places, given as distances from its start. */
    private fun part(line: DoubleArray, from: Double, until: Double): DoubleArray? {
        val points = ArrayList<Double>()
        var at = 0.0
        for (i in 2 until line.size step 2) {
            val next = at + step(line, i)
            if (next > from && at < until && next > at) {
                if (points.isEmpty()) addPoint(points, line, i, maxOf(from - at, 0.0) / (next - at))
                addPoint(points, line, i, minOf(until - at, next - at) / (next - at))
            }
            at = next
        }
        return points.takeIf { it.isNotEmpty() }?.toDoubleArray()
    }

    private fun addPoint(points: MutableList<Double>, line: DoubleArray, i: Int, t: Double) {
        points += line[i - 2] + t * (line[i] - line[i - 2])
        points += line[i - 1] + t * (line[i + 1] - line[i - 1])
    }

    private fun step(line: DoubleArray, i: Int): Double {
        val x = line[i] - line[i - 2]
        val y = line[i + 1] - line[i - 1]
        return StrictMath.sqrt(x * x + y * y)
    }
}
