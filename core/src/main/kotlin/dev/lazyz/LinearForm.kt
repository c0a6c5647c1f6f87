package dev.lazyz

/**
 * A quantity that changes evenly over the raster: v(x, y) = c + dx x + dy y, in 64-bit two's complement.
 *
 * x and y are the column and row of a sample. Addition wraps and is associative, so stepping along a row by [dx],
 * stepping down a column by [dy] and evaluating with [at] give the same bits (contract rule 3.1). Of a depth the upper
 * 32 bits are the integer part, the lower 32 the fraction; edge functions are integers. Immutable and thread safe.
 *
 * @property c value at sample (0, 0)
 * @property dx change from a column to the next
 * @property dy change from a row to the next
 */
public class LinearForm(public val c: Long, public val dx: Long, public val dy: Long) {
    /** Returns the value at sample ([x], [y]). Cost: two multiplications. */
    public fun at(x: Int, y: Int): Long = c + dx * x + dy * y

    override fun equals(other: Any?): Boolean =
        other is LinearForm && c == other.c && dx == other.dx && dy == other.dy

    override fun hashCode(): Int = (c.hashCode() * 31 + dx.hashCode()) * 31 + dy.hashCode()

    override fun toString(): String = "LinearForm($c + $dx x + $dy y)"

    public companion object {
        /** Returns the form whose integer part is [value] everywhere. */
        @JvmStatic
        public fun constant(value: Int): LinearForm = LinearForm((value.toLong() shl 32) + HALF, 0, 0)

        /** Half a unit of the integer part: added once, so that dropping the fraction rounds to nearest. */
        internal const val HALF: Long = 1L shl 31
    }
}
