package dev.lazyz.setup

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

    /** Returns the grid line nearest to [pixels]; halfway, the greater one, so that whole-pixel moves change nothing. */
    fun snap(pixels: Double): Int {
        val limit = GUARD.toDouble() * STEPS
        return Math.floor(pixels * STEPS + 0.5).coerceIn(-limit, limit).toInt()
    }

    /** Returns the first column (or row) whose sample is at [grid] or after it. */
    fun firstSample(grid: Int): Int = (grid - CENTER + STEPS - 1) shr SHIFT
}
