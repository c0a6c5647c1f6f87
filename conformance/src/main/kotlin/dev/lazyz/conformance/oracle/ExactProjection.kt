package dev.lazyz.conformance.oracle

import dev.lazyz.Depth
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.geometry.FillRule
import dev.lazyz.world.camera.Camera
import java.math.BigDecimal
import java.math.BigInteger
import java.math.MathContext
import java.math.RoundingMode
import org.joml.Matrix4dc
import org.joml.Vector3dc

/**
 * Projects polygons, points and lines in world space to [ExactPolygon]s, [ExactPoint]s and [ExactLine]s on a raster:
 * contract rules 1.3, 4.2 and 9.1 in 60 decimal digits.
 *
 * Vertices are transformed by the unmodified matrices of the camera, clipped at the near and the far plane, projected,
 * and snapped. The contract does not define the order in which a vertex's coordinates are computed in double precision.
 * Where a coordinate is too close to the border between two grid points (or depths), both are permitted, and there is
 * more than one correct polygon. Implements the rules independently of set-up. Immutable and thread safe.
 */
public class ExactProjection(private val raster: Raster, private val camera: Camera) {
    private val projection = camera.projectionMatrix(raster.width.toDouble() / raster.height)
    private val view = camera.viewMatrix()

    /**
     * Returns all polygons that the contract permits for [contours] in world space; null stands for a polygon that
     * covers nothing.
     *
     * Empty where the contract permits too much for a check: vertices that are huge, on a plane, or beyond the guard
     * band; a plane that cuts a contour more than twice (rule 9.2); more than 64 polygons.
     */
    public fun polygons(contours: List<List<Vector3dc>>, fillRule: FillRule): List<ExactPolygon?> {
        val all = contours.flatten()
        if (all.size < 3 || all.any { !it.isFinite }) return listOf(null)
        if (all.any { isHuge(it) }) return emptyList()
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

    /** Like [polygons], for a point with a [size] in pixels. */
    public fun points(position: Vector3dc, size: Double): List<ExactPoint?> {
        if (!position.isFinite) return listOf(null)
        if (isHuge(position)) return emptyList()
        val corner = toClip(position)
        for (plane in listOf(Corner::toNear, Corner::toFar)) {
            if (plane(corner).abs() < CLOSE) return emptyList()
            if (plane(corner).signum() < 0) return listOf(null)
        }
        return snaps(listOf(corner)).map { (x, y, depth) -> ExactPoint(x, y, depth, size) }
    }

    /** Like [polygons], for a line between two points with a [width] in pixels. */
    public fun lines(from: Vector3dc, to: Vector3dc, width: Double): List<ExactLine?> {
        if (!from.isFinite || !to.isFinite) return listOf(null)
        if (isHuge(from) || isHuge(to)) return emptyList()
        var ends = listOf(toClip(from), toClip(to))
        for (plane in listOf(Corner::toNear, Corner::toFar)) {
            val (d, e) = ends.map(plane)
            if (d.abs() < CLOSE || e.abs() < CLOSE) return emptyList()
            if (d.signum() < 0 && e.signum() < 0) return listOf(null)
            val cut = ends[0].toward(ends[1], d.abs() / (d.abs() + e.abs()))
            ends = listOf(if (d.signum() < 0) cut else ends[0], if (e.signum() < 0) cut else ends[1])
        }
        return snaps(ends).map { ExactLine(it.toIntArray(), width) }
    }

    private fun isHuge(p: Vector3dc): Boolean = maxOf(Math.abs(p.x()), Math.abs(p.y()), Math.abs(p.z())) > LARGEST

    /** Homogeneous clip coordinates; near is z = -w, far is z = w. */
    private class Corner(val x: BigDecimal, val y: BigDecimal, val z: BigDecimal, val w: BigDecimal) {
        fun toNear(): BigDecimal = w + z

        fun toFar(): BigDecimal = w - z

        /** Interpolates linearly between this point ([t] = 0) and [other] ([t] = 1). */
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

    /**
     * Returns the part inside of a plane: for each vertex the intersection on the edge to it, if any, then the vertex
     * itself.
     */
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

    private fun snapped(contours: List<List<Corner>>, fillRule: FillRule): List<ExactPolygon?> =
        snaps(contours.flatten()).map { numbersOfOne ->
            var at = 0
            val snapped = contours.map { contour ->
                IntArray(3 * contour.size) { numbersOfOne[at++] }
            }
            ExactPolygon(snapped, fillRule)
        }

    /** Returns every way to snap the vertices, as x, y and depth of each; empty where there are too many ways. */
    private fun snaps(corners: List<Corner>): List<List<Int>> {
        val numbers = corners.flatMap { corner ->
            val x = (corner.x / corner.w + BigDecimal.ONE) / TWO * big(raster.width.toDouble())
            val y = (BigDecimal.ONE - corner.y / corner.w) / TWO * big(raster.height.toDouble())
            if (maxOf(x.abs(), y.abs()) > GUARD) return emptyList()
            val depth = (corner.z / corner.w + BigDecimal.ONE) / TWO
            listOf(near(x * STEPS), near(y * STEPS), depths(depth))
        }
        if (numbers.fold(1L) { product, it -> minOf(product * it.size, 1000L) } > MOST) return emptyList()
        return numbers.fold(listOf(emptyList())) { lists, it -> lists.flatMap { l -> it.map { n -> l + n } } }
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

        /**
         * Distance from the border between two integers within which rounding in double precision decides, in grid
         * steps or units.
         */
        val BORDER: BigDecimal = BigDecimal("1e-4")

        /** Distance from a plane within which double precision decides on which side a vertex is, in world units. */
        val CLOSE: BigDecimal = BigDecimal("1e-9")

        const val LARGEST = 1e4
        const val MOST = 64L

        fun big(value: Double) = BigDecimal(value, digits)

        /**
         * Returns the integers to which [value] may be rounded: the nearest, half up, or both neighbours if it is close
         * to a half.
         */
        fun near(value: BigDecimal): List<Int> = listOf(value - BORDER, value + BORDER)
            .map { (it + HALF).setScale(0, RoundingMode.FLOOR).toInt() }.distinct()

        operator fun BigDecimal.times(other: BigDecimal): BigDecimal = multiply(other, digits)

        operator fun BigDecimal.div(other: BigDecimal): BigDecimal = divide(other, digits)
    }
}

/** Coverage of one sample by a surface in exact arithmetic. */
public enum class Coverage {
    /** The surface covers the sample. */
    COVERED,

    /** The surface does not cover the sample. */
    UNCOVERED,

    /** The sample is so close to the outline that the contract permits rounding to decide: both results are correct. */
    OPEN,
}

/**
 * A surface that is evaluated sample by sample, without set-up and without rounding. Oracles consist of such surfaces.
 *
 * Implementations are immutable and thread safe.
 */
public interface ExactSurface {
    /** Returns the coverage of the sample of column [x] and row [y]. Never [Coverage.OPEN] for flat surfaces. */
    public fun coverage(x: Int, y: Int): Coverage

    /**
     * Returns the absolute difference of [depth] from the exact depth at the covered sample of column [x] and row [y],
     * in units. Contract rule 4.4 permits at most 1.
     */
    public fun depthError(x: Int, y: Int, depth: Int): Double
}

/**
 * A point on the 1/256 pixel grid with the coverage of contract rule 2.9: the oracle for points.
 *
 * Implements the rule independently of set-up. Immutable and thread safe.
 *
 * @param x column of the vertex in grid steps
 * @param y row of the vertex in grid steps
 * @param depth depth of the vertex
 * @param size side of the square in pixels
 */
public class ExactPoint(private val x: Int, private val y: Int, private val depth: Int, size: Double) : ExactSurface {
    private val half = halfSize(size)

    override fun coverage(x: Int, y: Int): Coverage =
        if (isWithin(x, this.x) && isWithin(y, this.y)) Coverage.COVERED else Coverage.UNCOVERED

    private fun isWithin(sample: Int, vertex: Int): Boolean = 256L * sample + 128 - vertex in -half until half

    override fun depthError(x: Int, y: Int, depth: Int): Double = Math.abs(depth.toDouble() - this.depth)

    override fun toString(): String = "ExactPoint($x, $y, $depth, $half)"

    internal companion object {
        /** Returns half of a size in pixels, in grid steps. */
        fun halfSize(pixels: Double): Long = maxOf(StrictMath.floor(128.0 * pixels + 0.5).toLong(), 128L)
    }
}

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

    /** The four corners between the ends, without the points at the ends. */
    internal val quad: ExactPolygon
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
