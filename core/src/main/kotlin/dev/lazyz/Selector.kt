package dev.lazyz

/**
 * Chooses what a sample shows, given all its fragments: the paper's selection over a list of (depth, suspended colour).
 *
 * A selector is asked about each sample that is covered, once; samples that nothing covers show the background. It must
 * be a pure function of the cell, and thread safe. Give it to a renderer with [Capability.SELECTION] as
 * [RenderOptions.selector]. One of one's own, in Kotlin, shows what lies behind everything else if it is red:
 *
 *     val selector = Selector { cell ->
 *         val last = cell.size - 1
 *         cell.show(if (cell.shade(last).red > 0.5f) last else 0)
 *     }
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), where cells hold lists of pairs.
 */
public fun interface Selector {
    /** Looks at [cell] and calls [Cell.show] for what is to be seen; without a call the background is. */
    public fun select(cell: Cell)

    public companion object {
        /** Returns the usual selector: the visible fragment by the raster's depth test. One shading call a sample. */
        @JvmStatic
        public fun nearest(): Selector = NearestSelector

        /** Returns the selector of the fragment that the depth test ranks last: the back of everything. */
        @JvmStatic
        public fun farthest(): Selector = FarthestSelector

        /**
         * Returns the selector of the fragment number [k] by the depth test, 1 for the nearest; samples with fewer
         * fragments show the background. These are the layers of depth peeling, without the passes.
         *
         * @throws IllegalArgumentException if [k] is not positive
         */
        @JvmStatic
        public fun kthNearest(k: Int): Selector {
            require(k >= 1) { "k must be at least 1: $k" }
            return KthNearestSelector(k)
        }

        /**
         * Returns the selector that shows overdraw: the number of fragments as a colour, without any shading call.
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
         * Returns the selector that blends: translucent fragments in exact order of depth over the first opaque one, or
         * over the background (contract rule 5.5). Depth and primitive are those of the nearest fragment.
         */
        @JvmStatic
        public fun blend(): Selector = BlendSelector
    }
}

/**
 * The fragments of one sample, in the order of the raster's depth test: number 0 is the nearest.
 *
 * Only fragments that pass the depth test against the background are there. Colours are suspended: what is not shaded
 * costs nothing. Belongs to the renderer and is valid during [Selector.select] only.
 */
public interface Cell {
    /** Column of the sample. */
    public val x: Int

    /** Row of the sample. */
    public val y: Int

    /** Number of fragments, at least 1. */
    public val size: Int

    /** Colour behind all fragments, linear light. */
    public val background: Rgba

    /** Returns the depth of fragment [i], 0..2^31-1. Asking for number 0 only is cheaper: it saves sorting. */
    public fun depth(i: Int): Int

    /** Returns the submission index of the primitive of fragment [i]. */
    public fun primitive(i: Int): Int

    /** Returns whether fragment [i] belongs to a translucent primitive. */
    public fun isTranslucent(i: Int): Boolean

    /**
     * Forces the colour of fragment [i]: one shading call, each time. The fragment is the renderer's and is overwritten by
     * the next call.
     */
    public fun shade(i: Int): Fragment

    /** Shows fragment [i]: its colour, depth and primitive. The last call decides. */
    public fun show(i: Int)

    /** Shows the depth and the primitive of fragment [i] in another colour, linear light with straight alpha. */
    public fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float)
}
