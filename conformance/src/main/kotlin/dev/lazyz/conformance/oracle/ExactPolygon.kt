package dev.lazyz.conformance.oracle

import dev.lazyz.geometry.FillRule
import java.math.BigDecimal
import java.math.BigInteger
import java.math.MathContext

/**
 * A polygon on the 1/256 pixel grid with coverage and depth in exact rational arithmetic: the oracle for set-up.
 *
 * Implements contract rules 2 and 3 independently of set-up: every sample is decided on its own, with every edge, and
 * nothing is rounded. Use it to check primitives, not to render. Immutable and thread safe.
 *
 * Cost: linear in the number of vertices for each call.
 *
 * @param contours for each closed contour x, y, depth triples: x and y in grid steps within 2^27 of the origin, depth
 *   in 0..2^31-1; empty contours are ignored
 * @param fillRule which parts are inside
 * @throws IllegalArgumentException if a contour does not consist of triples, or there are fewer than three vertices
 */
public class ExactPolygon(contours: List<IntArray>, internal val fillRule: FillRule) : ExactSurface {
    /** As given, without empty contours. */
    internal val contours: List<IntArray> = contours.filter { it.isNotEmpty() }.map { it.copyOf() }
    private val vertices: List<Corner>
    private val reference: List<Corner>

    init {
        for (contour in contours) {
            require(contour.size % 3 == 0) { "a contour must be x, y, depth triples: ${contour.size} numbers" }
        }
        vertices = this.contours.flatMap { contour -> contour.indices.step(3).map { vertex(contour, it) } }
        require(vertices.size >= 3) { "a polygon must have three vertices: ${vertices.size}" }
        reference = referenceTriangle()
    }

    /**
     * Returns whether the sample of column [x] and row [y] is inside, with the top-left rule (contract rules 2.1 to
     * 2.4).
     */
    public fun covers(x: Int, y: Int): Boolean {
        val sampleX = sample(x)
        val sampleY = sample(y)
        var windings = 0
        for (contour in contours) {
            for (i in contour.indices step 3) {
                val from = vertex(contour, i)
                val to = vertex(contour, (i + 3) % contour.size)
                val isDown = from.y < to.y
                val upper = if (isDown) from else to
                val lower = if (isDown) to else from
                if (sampleY < upper.y || sampleY >= lower.y) continue

                // At or right of the crossing: x >= X0 + (y - Y0) (X1 - X0) / (Y1 - Y0), multiplied out
                val left = (sampleX - upper.x) * (lower.y - upper.y)
                val right = (sampleY - upper.y) * (lower.x - upper.x)
                if (left >= right) windings += if (isDown) 1 else -1
            }
        }
        return if (fillRule == FillRule.EVEN_ODD) windings % 2 != 0 else windings != 0
    }

    override fun coverage(x: Int, y: Int): Coverage = if (covers(x, y)) Coverage.COVERED else Coverage.UNCOVERED

    /**
     * Returns the absolute difference of [depth] from the exact depth at column [x] and row [y], in units.
     *
     * The exact depth is the plane through the reference triangle (rule 3.5) or, in the cases of rule 3.4, the depth of
     * the first vertex. The contract requires a difference of less than 1.
     */
    override fun depthError(x: Int, y: Int, depth: Int): Double {
        val plane = plane()
        if (isConstant(plane)) return Math.abs(depth.toDouble() - reference[0].depth)
        val difference = big(depth.toLong()) * plane.area - plane.timesArea(sample(x), sample(y))
        return BigDecimal(difference).divide(BigDecimal(plane.area), MathContext.DECIMAL64).abs().toDouble()
    }

    /**
     * Rule 3.4: too steep, without area, or a polygon with more than three vertices so warped that its plane leaves the
     * range.
     */
    private fun isConstant(plane: Plane): Boolean {
        if (plane.area.signum() == 0) return true
        val steep = plane.area.abs() * big(STEEP)
        if (plane.slopeX.abs() * STEPS >= steep || plane.slopeY.abs() * STEPS >= steep) return true
        if (vertices.size == 3) return false
        val bounds = listOf(BigInteger.ZERO, big(Int.MAX_VALUE.toLong()) * plane.area).sorted()
        return vertices.any { plane.timesArea(it.x, it.y) !in bounds[0]..bounds[1] }
    }

    /**
     * Returns three points x, y, depth whose plane has the depths of this polygon (rule 3.5). In the cases of rule 3.4,
     * all three have the same depth.
     */
    internal fun planePoints(): List<List<Long>> {
        val isLevel = isConstant(plane())
        return reference.map { listOf(it.x, it.y, if (isLevel) reference[0].depth else it.depth) }
    }

    private fun plane(): Plane {
        val (a, b, c) = reference
        val dx1 = big(b.x - a.x)
        val dy1 = big(b.y - a.y)
        val dx2 = big(c.x - a.x)
        val dy2 = big(c.y - a.y)
        val dv1 = big(b.depth - a.depth)
        val dv2 = big(c.depth - a.depth)
        return Plane(dx1 * dy2 - dx2 * dy1, dv1 * dy2 - dv2 * dy1, dv2 * dx1 - dv1 * dx2)
    }

    /** Twice the area of the reference triangle, and the change of depth per grid step, multiplied by [area]. */
    private inner class Plane(val area: BigInteger, val slopeX: BigInteger, val slopeY: BigInteger) {
        /** The plane's depth at a grid point, multiplied by [area]. */
        fun timesArea(x: Long, y: Long): BigInteger = big(reference[0].depth) * area +
            slopeX * big(x - reference[0].x) + slopeY * big(y - reference[0].y)
    }

    /** Rule 3.5: the first vertex, the one farthest from it, and the one farthest from the line through both. */
    private fun referenceTriangle(): List<Corner> {
        if (vertices.size == 3) return vertices
        val first = vertices[0]
        val second = vertices.maxBy { (it.x - first.x) * (it.x - first.x) + (it.y - first.y) * (it.y - first.y) }
        val third = vertices.maxBy {
            Math.abs((second.x - first.x) * (it.y - first.y) - (second.y - first.y) * (it.x - first.x))
        }
        return listOf(first, second, third)
    }

    override fun toString(): String = "ExactPolygon(${contours.map { it.toList() }}, $fillRule)"

    private class Corner(val x: Long, val y: Long, val depth: Long)

    private companion object {
        val STEPS: BigInteger = BigInteger.valueOf(256)

        /** A quarter of the range of depths. */
        const val STEEP = 1L shl 29

        fun sample(pixel: Int): Long = 256L * pixel + 128

        fun big(value: Long): BigInteger = BigInteger.valueOf(value)

        fun vertex(contour: IntArray, at: Int): Corner =
            Corner(contour[at].toLong(), contour[at + 1].toLong(), contour[at + 2].toLong())
    }
}
