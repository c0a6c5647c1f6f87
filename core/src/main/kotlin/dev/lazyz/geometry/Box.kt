package dev.lazyz.geometry

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * An axis-aligned box in world space. Its boundary is part of it, and its thickness can be 0.
 *
 * @property minX minimum x
 * @property minY minimum y
 * @property minZ minimum z
 * @property maxX maximum x
 * @property maxY maximum y
 * @property maxZ maximum z
 * @throws IllegalArgumentException if a bound is not finite or a minimum exceeds its maximum
 */
public class Box(
    public val minX: Double,
    public val minY: Double,
    public val minZ: Double,
    public val maxX: Double,
    public val maxY: Double,
    public val maxZ: Double,
) {
    init {
        require(minX <= maxX && minY <= maxY && minZ <= maxZ) { "minimum of a box must not exceed its maximum: $this" }
        require((maxX - minX).isFinite() && (maxY - minY).isFinite() && (maxZ - minZ).isFinite()) {
            "box must be finite: $this"
        }
    }

    /** The centre of the box; a new vector for each call. */
    public val center: Vector3d
        get() = Vector3d(minX + (maxX - minX) / 2, minY + (maxY - minY) / 2, minZ + (maxZ - minZ) / 2)

    /**
     * Returns corner [number], 0..7. Bit 0 selects the maximum of x, bit 1 of y, bit 2 of z. A new vector for each
     * call.
     *
     * @throws IllegalArgumentException if [number] is not in 0..7
     */
    public fun corner(number: Int): Vector3d {
        require(number in 0..7) { "corner must be in 0..7: $number" }
        return Vector3d(
            if (number and 1 == 0) minX else maxX,
            if (number and 2 == 0) minY else maxY,
            if (number and 4 == 0) minZ else maxZ,
        )
    }

    /** Returns the corner whose dot product with [direction] is greatest. A new vector for each call. */
    public fun farthest(direction: Vector3dc): Vector3d = Vector3d(
        if (direction.x() < 0.0) minX else maxX,
        if (direction.y() < 0.0) minY else maxY,
        if (direction.z() < 0.0) minZ else maxZ,
    )

    /** Returns the smallest box that contains both. */
    public fun union(other: Box): Box = Box(
        minOf(minX, other.minX),
        minOf(minY, other.minY),
        minOf(minZ, other.minZ),
        maxOf(maxX, other.maxX),
        maxOf(maxY, other.maxY),
        maxOf(maxZ, other.maxZ),
    )

    /** Returns the box translated by [way]. */
    internal fun moved(way: Vector3dc): Box = Box(
        minX + way.x(), minY + way.y(), minZ + way.z(),
        maxX + way.x(), maxY + way.y(), maxZ + way.z(),
    )

    /**
     * Returns a suitable origin for the contents of this box: the centre of the box if the box is so small and so far
     * from the world's origin that 32-bit floats would lose details; otherwise the world's origin. A new vector for
     * each call.
     */
    public fun origin(): Vector3d {
        val far = listOf(minX, minY, minZ, maxX, maxY, maxZ).maxOf { StrictMath.abs(it) }
        val size = maxOf(maxX - minX, maxY - minY, maxZ - minZ)
        return if (far > FAR * size) center else Vector3d()
    }

    override fun toString(): String = "Box($minX..$maxX, $minY..$maxY, $minZ..$maxZ)"

    public companion object {
        /**
         * Returns the smallest box around points given as x, y, z triples, or null if no point is finite. Points with a
         * NaN or infinite coordinate are ignored, as by every renderer (contract rule 9.5). Cost: linear in the number
         * of points.
         */
        @JvmStatic
        public fun around(xyz: FloatArray): Box? = around(xyz.size / 3) { point, axis ->
            xyz[3 * point + axis].toDouble()
        }

        /**
         * Same for [count] points. [coordinate] returns one coordinate of a point; axis is 0..2. Points with a
         * coordinate that is [LARGEST] or more in absolute value are ignored too.
         */
        internal inline fun around(count: Int, coordinate: (point: Int, axis: Int) -> Double): Box? {
            val low = doubleArrayOf(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY)
            val high = doubleArrayOf(Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY)
            val point = DoubleArray(3)
            for (i in 0 until count) {
                for (axis in 0 until 3) point[axis] = coordinate(i, axis)
                if (point.any { !(StrictMath.abs(it) < LARGEST) }) continue
                for (axis in 0 until 3) {
                    low[axis] = minOf(low[axis], point[axis])
                    high[axis] = maxOf(high[axis], point[axis])
                }
            }
            if (low[0] > high[0]) return null
            return Box(low[0], low[1], low[2], high[0], high[1], high[2])
        }

        /**
         * Maximum distance from the world's origin, as a multiple of an object's size. At this distance, 18 of the 24
         * bits of a float's significand remain for details: an eighth of a pixel in an image of 32,768 pixels.
         */
        private const val FAR = 64.0

        /**
         * Coordinates of this magnitude or more are treated as infinite, because sums and products of them could
         * overflow.
         */
        internal const val LARGEST: Double = 1e100
    }
}

/** What takes up a part of world space, a surface or a whole scene. */
public interface Extent {
    /** A box around it, or null if it is empty. */
    public val bounds: Box?

    /**
     * Returns the point that is farthest along [direction]: the one whose dot product with it is greatest; one of them
     * if there are several, or null if there is none. World space; a new vector for each call. [direction] has any
     * length above 0.
     *
     * A fitted camera calls it some 30 times, see `Camera.fit`. What does not override this function is fitted by its
     * [bounds], so it can look smaller than it could.
     */
    public fun farthest(direction: Vector3dc): Vector3d? = bounds?.farthest(direction)
}
