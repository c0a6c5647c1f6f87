package dev.lazyz

import dev.lazyz.Selector.Cell
import dev.lazyz.spi.Fragment

/**
 * Chooses what a sample shows, given all its fragments. This is the selection over a list of (depth, suspended colour)
 * of Hill's paper.
 *
 * A selector is called once for each sample that has a fragment; other samples show the background. It must be a pure
 * function of the cell, and thread safe. Pass it to a renderer with [Capability.SELECTION] as [RenderOptions.selector].
 * For example, this custom selector in Kotlin shows the farthest fragment if it is red, and otherwise the nearest:
 *
 *     val selector = Selector { cell ->
 *         val last = cell.size - 1
 *         cell.show(if (cell.shade(last).red > 0.5f) last else 0)
 *     }
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), where cells hold lists of pairs.
 */
public fun interface Selector {
    /**
     * Examines [cell] and calls [Cell.show] to set what the sample shows. Without a call, the sample shows the
     * background.
     */
    public fun select(cell: Cell)

    /**
     * The fragments of one sample, in the order of the raster's depth test: fragment 0 is the nearest.
     *
     * Contains only fragments that pass the depth test against the background. Colours are computed on demand by
     * [shade]. The cell belongs to the renderer and is valid only during [Selector.select].
     */
    public interface Cell {
        /** Column of the sample. */
        public val x: Int

        /** Row of the sample. */
        public val y: Int

        /** Number of fragments, at least 1. */
        public val size: Int

        /** Colour of the background, linear light. */
        public val background: Rgba

        /**
         * Returns the depth of fragment [i], 0..2^31-1. Accessing only fragment 0 is cheaper, because it needs no
         * sorting.
         */
        public fun depth(i: Int): Int

        /** Returns the submission index of the primitive of fragment [i]. */
        public fun primitive(i: Int): Int

        /** Returns whether fragment [i] belongs to a translucent primitive. */
        public fun isTranslucent(i: Int): Boolean

        /**
         * Computes the colour of fragment [i]; each call is one shading call. The result belongs to the renderer and is
         * overwritten by the next call.
         */
        public fun shade(i: Int): Fragment

        /** Sets the sample to the colour, depth and primitive of fragment [i]. The last call of `show` is used. */
        public fun show(i: Int)

        /**
         * Sets the sample to the depth and primitive of fragment [i], and to the given colour, linear light with
         * straight alpha.
         */
        public fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float)
    }

    public companion object {
        /**
         * Returns the default selector for opaque frames: shows the visible fragment by the raster's depth test. Cost:
         * one shading call a sample.
         */
        @JvmStatic
        public fun nearest(): Selector = NearestSelector

        /** Returns the selector that shows the fragment that the depth test ranks last: the farthest one. */
        @JvmStatic
        public fun farthest(): Selector = FarthestSelector

        /**
         * Returns the selector that shows the [k]-th fragment by the depth test, 1 for the nearest. Samples with fewer
         * fragments show the background. The results are the layers of depth peeling, without several passes.
         *
         * @throws IllegalArgumentException if [k] is not positive
         */
        @JvmStatic
        public fun kthNearest(k: Int): Selector {
            require(k >= 1) { "k must be at least 1: $k" }
            return KthNearestSelector(k)
        }

        /**
         * Returns the selector that shows overdraw: the number of fragments as a colour, without shading calls.
         *
         * | fragments | sRGB      | | fragments   | sRGB      |
         * |-----------|-----------|-|-------------|-----------|
         * | 1         | `#440154` | | 5 to 8      | `#1fa187` |
         * | 2         | `#46327e` | | 9 to 16     | `#4ac16d` |
         * | 3         | `#365c8d` | | 17 to 32    | `#a0da39` |
         * | 4         | `#277f8e` | | 33 and more | `#fde725` |
         *
         * Fragments that do not pass the depth test against the background are not counted. Depth and primitive are
         * those of the nearest fragment.
         */
        @JvmStatic
        public fun count(): Selector = CountSelector

        /**
         * Returns the selector that blends translucent fragments in exact depth order over the first opaque one, or
         * over the background (contract rule 5.5). Depth and primitive are those of the nearest fragment.
         */
        @JvmStatic
        public fun blend(): Selector = BlendSelector
    }
}

/** See [Selector.nearest]. */
internal object NearestSelector : Selector {
    override fun select(cell: Cell) = cell.show(0)

    override fun toString(): String = "nearest"
}

/** See [Selector.farthest]. */
internal object FarthestSelector : Selector {
    override fun select(cell: Cell) = cell.show(cell.size - 1)

    override fun toString(): String = "farthest"
}

/** See [Selector.kthNearest]. */
internal class KthNearestSelector(private val k: Int) : Selector {
    override fun select(cell: Cell) {
        if (k <= cell.size) cell.show(k - 1)
    }

    override fun equals(other: Any?): Boolean = other is KthNearestSelector && k == other.k

    override fun hashCode(): Int = k

    override fun toString(): String = "kthNearest($k)"
}

/** See [Selector.count]. */
internal object CountSelector : Selector {
    private val colors = List(8) { Rgba.viridis(it / 7.0) }

    override fun select(cell: Cell) {
        val color = colors[step(cell.size)]
        cell.show(0, color.red, color.green, color.blue, color.alpha)
    }

    private fun step(count: Int): Int = when {
        count <= 4 -> count - 1
        count <= 8 -> 4
        count <= 16 -> 5
        count <= 32 -> 6
        else -> 7
    }

    override fun toString(): String = "count"
}

/** See [Selector.blend]. */
internal object BlendSelector : Selector {
    override fun select(cell: Cell) {
        // An opaque fragment in front hides everything else
        if (!cell.isTranslucent(0)) {
            cell.show(0)
            return
        }
        val blending = Blending()
        blending.clear()
        var i = 0
        while (i < cell.size && cell.isTranslucent(i) && blending.isOpen) blending.add(cell.shade(i++))

        // The backdrop comes last, if any light from it passes through
        if (blending.isOpen && i < cell.size) blending.end(cell.shade(i)) else blending.end(cell.background)
        cell.show(0, blending.red, blending.green, blending.blue, blending.alpha)
    }

    override fun toString(): String = "blend"
}
