package dev.lazyz.spi

/**
 * A linear function of the sample position: v(x, y) = c + dx x + dy y, in 64-bit two's complement.
 *
 * x and y are the column and row of a sample. Addition wraps and is associative, so stepping along a row by [dx],
 * stepping down a column by [dy] and evaluating with [at] give the same result, bit for bit (contract rule 3.1). In the
 * form of a depth, the upper 32 bits are the integer part and the lower 32 the fraction. Edge functions are plain
 * integers. Immutable and thread safe.
 *
 * @property c value at sample (0, 0)
 * @property dx change from one column to the next
 * @property dy change from one row to the next
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

        /** Half a unit of the integer part. It is added once, so that truncating the fraction rounds to nearest. */
        internal const val HALF: Long = 1L shl 31
    }
}
