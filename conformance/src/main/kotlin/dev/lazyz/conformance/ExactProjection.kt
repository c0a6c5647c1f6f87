package dev.lazyz.conformance

import dev.lazyz.Camera
import dev.lazyz.Depth
import dev.lazyz.DepthConvention
import dev.lazyz.FillRule
import dev.lazyz.Raster
import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode
import org.joml.Matrix4dc
import org.joml.Vector3dc

/**
 * Polygons in space as [ExactPolygon]s on a raster: rules 1.3, 4.2 and 9.1 in 60 decimal digits.
 *
 * Vertices are transformed by the camera's matrices, as they are; cut at the near and the far plane; projected; and
 * snapped. The contract does not say in which order a vertex's coordinates are computed in double precision: where a
 * coordinate lies too close to the border between two grid points (or depths), both are permitted, and there is more
 * than one right polygon. Written from the rules, and independent of set-up. Immutable and thread safe.
 */
public class ExactProjection(private val raster: Raster, private val camera: Camera) {
    private val projection = camera.projectionMatrix(raster.width.toDouble() / raster.height)
    private val view = camera.viewMatrix()

    /**
     * Returns all polygons that the contract permits for [contours], world space; null among them covers nothing.
     *
     * Empty where the contract leaves too much open to judge: vertices that are huge, on a plane, or in the guard
     * band's reach; a plane that cuts a contour more than twice (rule 9.2); more than 64 polygons.
     */
    public fun polygons(contours: List<List<Vector3dc>>, fillRule: FillRule): List<ExactPolygon?> {
        val all = contours.flatten()
        if (all.size < 3 || all.any { !it.isFinite }) return listOf(null)
        if (all.any { maxOf(Math.abs(it.x()), Math.abs(it.y()), Math.abs(it.z())) > LARGEST }) return emptyList()
        var pieces = contours.map { contour -> contour.map(::toClip) }
        for (plane in listOf(Corner::toNear, Corner::toFar)) {
            if (pieces.flatten().any { plane(it).abs() < CLOSE }) return emptyList()
            if (pieces.sumOf { cuts(it, plane) } > 2) return emptyList()
            pieces = pieces.map { cut(it, plane) }
        }
        pieces = pieces.filter { it.isNotEmpty() }
        if (pieces.sumOf { it.size } < 3) return listOf(null)
        return snapped(pieces, fillRule)
    }

    /** Homogeneous clip coordinates; near is z = -w, far is z = w. */
    private class Corner(val x: BigDecimal, val y: BigDecimal, val z: BigDecimal, val w: BigDecimal) {
        fun toNear(): BigDecimal = w + z

        fun toFar(): BigDecimal = w - z

        /** The point a fraction [t] of the way to [other]. */
        fun toward(other: Corner, t: BigDecimal) = Corner(
            x + t * (other.x - x),
            y + t * (other.y - y),
            z + t * (other.z - z),
            w + t * (other.w - w),
        )
    }

    private fun toClip(p: Vector3dc): Corner {
        val seen = times(view, listOf(big(p.x()), big(p.y()), big(p.z()), BigDecimal.ONE))
        val (x, y, z, w) = times(projection, seen)
        return Corner(x, y, z, w)
    }

    private fun times(m: Matrix4dc, v: List<BigDecimal>): List<BigDecimal> = (0 until 4).map { row ->
        (0 until 4).fold(BigDecimal.ZERO) { sum, column -> sum + big(m.get(column, row)) * v[column] }
    }

    private fun cuts(contour: List<Corner>, plane: (Corner) -> BigDecimal): Int = contour.indices.count {
        plane(contour[it]).signum() != plane(contour[(it + 1) % contour.size]).signum()
    }

    /** What is left inside of a plane: for each vertex the cut on the way to it, if there is one, and then itself. */
    private fun cut(contour: List<Corner>, plane: (Corner) -> BigDecimal): List<Corner> {
        val left = ArrayList<Corner>()
        for ((i, to) in contour.withIndex()) {
            val from = contour[(i + contour.size - 1) % contour.size]
            val d = plane(from)
            val e = plane(to)
            if (d.signum() != e.signum()) left.add(from.toward(to, d.abs() / (d.abs() + e.abs())))
            if (e.signum() >= 0) left.add(to)
        }
        return left
    }

    /** Every way to snap the vertices. */
    private fun snapped(contours: List<List<Corner>>, fillRule: FillRule): List<ExactPolygon?> {
        val numbers = contours.flatten().flatMap { corner ->
            val x = (corner.x / corner.w + BigDecimal.ONE) / TWO * big(raster.width.toDouble())
            val y = (BigDecimal.ONE - corner.y / corner.w) / TWO * big(raster.height.toDouble())
            if (maxOf(x.abs(), y.abs()) > GUARD) return emptyList()
            val depth = (corner.z / corner.w + BigDecimal.ONE) / TWO
            listOf(near(x * STEPS), near(y * STEPS), depths(depth))
        }
        if (numbers.fold(1L) { product, it -> minOf(product * it.size, 1000L) } > MOST) return emptyList()
        val choices = numbers.fold(listOf(emptyList<Int>())) { lists, it ->
            lists.flatMap { l -> it.map { n -> l + n } }
        }
        return choices.map { numbersOfOne ->
            var at = 0
            val snapped = contours.map { contour ->
                IntArray(3 * contour.size) { numbersOfOne[at++] }
            }
            ExactPolygon(snapped, fillRule)
        }
    }

    private fun depths(unit: BigDecimal): List<Int> {
        val depth = big(Depth.NEAR.toDouble()) + unit * big(Depth.FAR.toDouble() - Depth.NEAR)
        val isMirrored = raster.convention == DepthConvention.LARGER_IS_NEARER
        return near(depth).map { it.coerceIn(Depth.NEAR, Depth.FAR) }.distinct()
            .map { if (isMirrored) Int.MAX_VALUE - it else it }
    }

    override fun toString(): String = "ExactProjection($raster, $camera)"

    private companion object {
        val digits = MathContext(60)
        val TWO: BigDecimal = BigDecimal.valueOf(2)
        val STEPS: BigDecimal = BigDecimal.valueOf(256)
        val HALF: BigDecimal = BigDecimal("0.5")
        val GUARD: BigDecimal = BigDecimal.valueOf(1L shl 18)

        /** How close to the border between two integers double precision decides, in grid steps or units. */
        val BORDER: BigDecimal = BigDecimal("1e-4")

        /** How close to a plane double precision decides on which side a vertex is, world units. */
        val CLOSE: BigDecimal = BigDecimal("1e-9")

        const val LARGEST = 1e4
        const val MOST = 64L

        fun big(value: Double) = BigDecimal(value, digits)

        /** The integers that [value] may be rounded to: nearest, half up, and both next to a half. */
        fun near(value: BigDecimal): List<Int> = listOf(value - BORDER, value + BORDER)
            .map { (it + HALF).setScale(0, RoundingMode.FLOOR).toInt() }.distinct()

        operator fun BigDecimal.times(other: BigDecimal): BigDecimal = multiply(other, digits)

        operator fun BigDecimal.div(other: BigDecimal): BigDecimal = divide(other, digits)
    }
}
