package dev.lazyz.conformance.oracle

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
