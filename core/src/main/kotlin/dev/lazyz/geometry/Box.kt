package dev.lazyz.geometry

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * An axis-aligned box in world space, closed on all sides; possibly of no thickness.
 *
 * @property minX least x
 * @property minY least y
 * @property minZ least z
 * @property maxX greatest x
 * @property maxY greatest y
 * @property maxZ greatest z
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
        require(minX <= maxX && minY <= maxY && minZ <= maxZ) { "box must not be inside out: $this" }
        require((maxX - minX).isFinite() && (maxY - minY).isFinite() && (maxZ - minZ).isFinite()) {
            "box must be finite: $this"
        }
    }

    /** The middle of the box; a new vector at each call. */
    public val center: Vector3d
        get() = Vector3d(minX + (maxX - minX) / 2, minY + (maxY - minY) / 2, minZ + (maxZ - minZ) / 2)

    /** Returns the corner with the given number, 0..7; bit 0 chooses maximum x, bit 1 y, bit 2 z. */
    public fun corner(number: Int): Vector3d {
        require(number in 0..7) { "corner must be in 0..7: $number" }
        return Vector3d(
            if (number and 1 == 0) minX else maxX,
            if (number and 2 == 0) minY else maxY,
            if (number and 4 == 0) minZ else maxZ,
        )
    }

    /** Returns the least box that holds both. */
    public fun union(other: Box): Box = Box(
        minOf(minX, other.minX),
        minOf(minY, other.minY),
        minOf(minZ, other.minZ),
        maxOf(maxX, other.maxX),
        maxOf(maxY, other.maxY),
        maxOf(maxZ, other.maxZ),
    )

    /** Returns the box moved by [way]. */
    internal fun moved(way: Vector3dc): Box = Box(
        minX + way.x(), minY + way.y(), minZ + way.z(),
        maxX + way.x(), maxY + way.y(), maxZ + way.z(),
    )

    /**
     * Returns where the origin of what fills this box should be: in its middle if it is so small and so far away that
     * 32-bit floats could not tell its details, or else that of the world.
     */
    public fun origin(): Vector3d {
        val far = listOf(minX, minY, minZ, maxX, maxY, maxZ).maxOf { StrictMath.abs(it) }
        val size = maxOf(maxX - minX, maxY - minY, maxZ - minZ)
        return if (far > FAR * size) center else Vector3d()
    }

    override fun toString(): String = "Box($minX..$maxX, $minY..$maxY, $minZ..$maxZ)"

    public companion object {
        /**
         * Returns the least box around points given as x, y, z triples, or null if no point is finite. Points with a
         * coordinate that is NaN or infinite are passed over, as they are by every renderer (contract rule 9.5).
         */
        @JvmStatic
        public fun around(xyz: FloatArray): Box? = around(xyz.size / 3) { point, axis ->
            xyz[3 * point + axis].toDouble()
        }

        /** As above, for [count] points whose coordinates [coordinate] gives by number and axis, 0..2. */
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
         * How many times its size something may be away from the world's origin. Of the 24 binary places of a float, 18
         * are left there for the details: an eighth of a pixel in a picture of 32,768.
         */
        private const val FAR = 64.0

        /** Coordinates from here on are treated as infinite: they could not be added up and multiplied. */
        internal const val LARGEST: Double = 1e100
    }
}
