package dev.lazyz.raster

/**
 * The 1/256 pixel grid that vertices are snapped to (contract rules 1.2 and 1.3).
 *
 * The sample of column x is at `256 x + 128`, of row y at `256 y + 128`.
 */
internal object ScreenGrid {
    /** Grid steps a pixel. */
    const val STEPS: Int = 256

    /** Base-2 logarithm of [STEPS]. */
    const val SHIFT: Int = 8

    /** Offset of the sample from the upper left corner of its pixel, grid steps. */
    const val CENTER: Int = STEPS / 2

    /** The guard band: no vertex is farther than this from the raster's origin, in pixels. */
    const val GUARD: Int = 1 shl 19

    /** Maximum size of points and width of lines, in pixels. */
    const val GREATEST_SIZE: Int = 1 shl 12

    /** The guard band of lines, in pixels. It is smaller, so that the corners of a widened line stay within [GUARD]. */
    const val LINE_GUARD: Int = GUARD - GREATEST_SIZE

    /**
     * Returns half of [size] (pixels) in grid steps. The result is at least half a pixel, so that a point covers a
     * sample.
     */
    fun half(size: Double): Int = maxOf(Math.floor(size * CENTER + 0.5).toInt(), CENTER)

    /**
     * Returns the grid position nearest to [pixels], clamped to the guard band. Ties round up, so that moving by whole
     * pixels does not change how a position rounds.
     */
    fun snap(pixels: Double): Int {
        val limit = GUARD.toDouble() * STEPS
        return Math.floor(pixels * STEPS + 0.5).coerceIn(-limit, limit).toInt()
    }

    /** Returns the first column (or row) whose sample is at or after the grid position [grid]. */
    fun firstSample(grid: Int): Int = (grid - CENTER + STEPS - 1) shr SHIFT

    /** Passes to [use] the columns and rows of the samples in the bounds of a triangle; ends are exclusive. */
    inline fun <R> bounds(
        ax: Int,
        ay: Int,
        bx: Int,
        by: Int,
        cx: Int,
        cy: Int,
        use: (columnStart: Int, rowStart: Int, columnEnd: Int, rowEnd: Int) -> R,
    ): R = use(
        firstSample(minOf(ax, minOf(bx, cx))), firstSample(minOf(ay, minOf(by, cy))),
        firstSample(maxOf(ax, maxOf(bx, cx))), firstSample(maxOf(ay, maxOf(by, cy))),
    )
}
