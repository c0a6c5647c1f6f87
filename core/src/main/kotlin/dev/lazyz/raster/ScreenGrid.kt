package dev.lazyz.raster

/**
 * The 1/256 pixel grid that vertices are snapped to (contract rules 1.2 and 1.3).
 *
 * The sample of column x is at `256 x + 128`, of row y at `256 y + 128`.
 */
internal object ScreenGrid {
    /** Grid steps a pixel. */
    const val STEPS: Int = 256

    /** Binary logarithm of [STEPS]. */
    const val SHIFT: Int = 8

    /** From a pixel's corner to its sample. */
    const val CENTER: Int = STEPS / 2

    /** No vertex is further than this from the raster's origin, in pixels: the guard band. */
    const val GUARD: Int = 1 shl 19

    /** Greatest size of points and width of lines, in pixels. */
    const val GREATEST_SIZE: Int = 1 shl 12

    /** Lines are clipped to this many pixels from the raster's origin, so that their corners stay within [GUARD]. */
    const val LINE_GUARD: Int = GUARD - GREATEST_SIZE

    /** Returns half of a size in pixels, in grid steps: at least half a pixel, so that a point has a sample. */
    fun half(size: Double): Int = maxOf(Math.floor(size * CENTER + 0.5).toInt(), CENTER)

    /** Returns the grid line nearest to [pixels]; halfway, the greater one, so that whole-pixel moves change nothing. */
    fun snap(pixels: Double): Int {
        val limit = GUARD.toDouble() * STEPS
        return Math.floor(pixels * STEPS + 0.5).coerceIn(-limit, limit).toInt()
    }

    /** Returns the first column (or row) whose sample is at [grid] or after it. */
    fun firstSample(grid: Int): Int = (grid - CENTER + STEPS - 1) shr SHIFT
}
