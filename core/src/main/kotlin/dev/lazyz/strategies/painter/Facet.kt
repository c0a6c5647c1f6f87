package dev.lazyz.strategies.painter

import dev.lazyz.HeapLayout
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.bytes

/**
 * What Newell's tests need to know about a primitive: the corners of its outline, and its depth plane.
 *
 * A linear form is exact at the primitive's own samples; elsewhere its value may not fit into 64 bits. The plane is
 * therefore extrapolated from the first corner, in double precision with a bound on the error.
 */
internal class Facet private constructor(
    val outline: Outline,
    private val form: LinearForm?,
    private val values: LongArray,
) {
    /** Whether depth is a single plane over all samples of the primitive. */
    val isFlat: Boolean = form != null && outline.count > 0 && isOnePlane()

    /** Number of corners at which depth was evaluated. */
    val valueCount: Int get() = values.size

    /** Bytes held. */
    val bytes: Long get() = HeapLayout.FACET + 8L * outline.count + values.bytes

    /** Whether both lie in exactly the same plane. */
    fun isSamePlane(other: Facet): Boolean = form == other.form

    /**
     * Returns a lower bound of [sign] (1 or -1) times the height of this plane above that of [other] at column [x] and
     * row [y], in units of linear forms. The bound is lower than the exact value only by rounding, about 2^-49 of the
     * numbers that were added.
     */
    fun leastHeight(other: Facet, x: Int, y: Int, sign: Double): Double {
        val across = form!!.dx.toDouble() * (x - outline.xs[0])
        val down = form.dy.toDouble() * (y - outline.ys[0])
        val otherAcross = other.form!!.dx.toDouble() * (x - other.outline.xs[0])
        val otherDown = other.form.dy.toDouble() * (y - other.outline.ys[0])
        val over = (values[0] - other.values[0]).toDouble()

        // A number takes part in at most two roundings before the sums and four in them, each at most 2^-53 of its
        // contribution
        val height = over + ((across + down) - (otherAcross + otherDown))
        val sum = StrictMath.abs(over) + StrictMath.abs(across) + StrictMath.abs(down) +
            StrictMath.abs(otherAcross) + StrictMath.abs(otherDown)
        return sign * height - ROUNDING * sum
    }

    /**
     * Whether the plane through the first corner equals the form at all corners. If so, the form is in range there and
     * at all samples in between, and never wraps: a form that wraps is off by a multiple of 2^64. Only forms of custom
     * primitives can wrap.
     */
    private fun isOnePlane(): Boolean {
        for (i in values.indices) {
            val across = form!!.dx.toDouble() * (outline.xs[i] - outline.xs[0])
            val down = form.dy.toDouble() * (outline.ys[i] - outline.ys[0])
            val error = StrictMath.abs((across + down) - (values[i] - values[0]).toDouble())
            if (error > HALF_WRAP) return false
        }
        return true
    }

    companion object {
        private const val ROUNDING = 1.0 / (1L shl 49)

        /** 2^63: rounding errors are far smaller, and a wrapped value is off by twice as much. */
        private const val HALF_WRAP = 9223372036854775808.0

        /** Examines the samples of [primitive] in [region]. Cost: see [Outline.of]. */
        fun of(primitive: Primitive, region: Region): Facet {
            val outline = Outline.of(primitive, region)
            val form = primitive.depthForm
            val values = LongArray(if (form == null) 0 else outline.count) { form!!.at(outline.xs[it], outline.ys[it]) }
            return Facet(outline, form, values)
        }
    }
}
