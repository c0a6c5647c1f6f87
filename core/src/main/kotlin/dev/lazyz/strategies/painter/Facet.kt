package dev.lazyz.strategies.painter

import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Region

/**
 * What Newell's tests need to know of a primitive: the corners of its outline, and its plane of depth.
 *
 * A linear form is exact at the primitive's own samples; elsewhere it may not fit 64 bits. The plane is therefore
 * extrapolated from the first corner, in double precision with a bound of its error.
 */
internal class Facet private constructor(
    val outline: Outline,
    private val form: LinearForm?,
    private val values: LongArray,
) {
    /** Whether depth is one plane over all samples of the primitive. */
    val isFlat: Boolean = form != null && outline.count > 0 && isOnePlane()

    /** Number of corners at which depth was evaluated. */
    val valueCount: Int get() = values.size

    /** Bytes held. */
    val bytes: Long get() = FIELD_BYTES + 8L * outline.count + 8L * values.size

    /** Whether both lie in the same plane, to the last bit. */
    fun isSamePlane(other: Facet): Boolean = form == other.form

    /**
     * Returns a lower bound of [sign] (1 or -1) times the height of this plane over that of [other] at column [x] and
     * row [y], as linear forms count. It falls short by rounding only, about 2^-49 of the numbers that were added.
     */
    fun leastHeight(other: Facet, x: Int, y: Int, sign: Double): Double {
        val across = form!!.dx.toDouble() * (x - outline.xs[0])
        val down = form.dy.toDouble() * (y - outline.ys[0])
        val otherAcross = other.form!!.dx.toDouble() * (x - other.outline.xs[0])
        val otherDown = other.form.dy.toDouble() * (y - other.outline.ys[0])
        val over = (values[0] - other.values[0]).toDouble()

        // A number takes part in at most two roundings before the sums and four in them, each of 2^-53 of what it gives
        val height = over + ((across + down) - (otherAcross + otherDown))
        val sum = StrictMath.abs(over) + StrictMath.abs(across) + StrictMath.abs(down) +
            StrictMath.abs(otherAcross) + StrictMath.abs(otherDown)
        return sign * height - ROUNDING * sum
    }

    /**
     * Whether the plane through the first corner is the form at all corners. Then it is in range there, so at all
     * samples in between, and never wraps: a form that wraps is off by a multiple of 2^64. Only forms of the user's
     * own ever do.
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

        /** 2^63: rounding is far less, and wrapping is twice as much. */
        private const val HALF_WRAP = 9223372036854775808.0
        private const val FIELD_BYTES = 136L

        /** Looks at the samples of [primitive] in [region]. Cost: see [Outline.of]. */
        fun of(primitive: Primitive, region: Region): Facet {
            val outline = Outline.of(primitive, region)
            val form = primitive.depthForm
            val values = LongArray(if (form == null) 0 else outline.count) { form!!.at(outline.xs[it], outline.ys[it]) }
            return Facet(outline, form, values)
        }
    }
}
